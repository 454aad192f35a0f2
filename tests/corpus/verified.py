"""Whether a written field is right, by the independent verifier of tests/verify."""

import verify


def verified(path):
    """Nothing if every check of the .vtu holds, otherwise the checks that failed."""
    report = verify.verify(path)
    if not report.checks:
        return f"there is nothing to verify in {path}"
    return report.text(everything=False) if report.failures() else None
