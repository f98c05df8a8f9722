"""Errors that whoever called can mend."""


class UserError(Exception):
    """Its message says what to do next; commands print it without a traceback and end with status 1."""
