"""What the user can mend."""

from ndframe.errors import Error


class UsageError(Error):
    """A file that cannot be read, an option that makes no sense; ends the program with exit code 2."""
