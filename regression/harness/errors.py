"""What the user can mend."""


class UsageError(Exception):
    """A file that cannot be read, an option that makes no sense; ends the program with exit code 2."""
