"""Whole sequences tracked and scored against their truth."""
