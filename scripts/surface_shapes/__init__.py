"""Surfaces for the gallery of surfaces and the pictures of docs/surfaces.md."""
