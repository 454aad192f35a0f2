/**
 * Runs the cases that --gtest_filter selects. Exits with 77, which ctest reports as skipped, if a case was skipped and none failed, and
 * with 1 if the filter selects none.
 */
#include <gtest/gtest.h>

#include <iostream>

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  const int status = RUN_ALL_TESTS();
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  if (status != 0 || GTEST_FLAG_GET(list_tests))
  {
    return status;
  }
  if (tests.test_to_run_count() == 0)
  {
    std::cerr
      << "No case has run. Compare --gtest_filter with the names that --gtest_list_tests prints.\n";
    return 1;
  }
  return tests.skipped_test_count() > 0 ? 77 : 0;
}
