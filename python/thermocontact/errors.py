# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program says when it ends without a result, or with a doubtful one."""


class Error(Exception):
    """The message of the program, or of this module."""


class InputError(Error):
    """The input is wrong (exit status 2): place, value, what is allowed, the remedy."""


class RunWarning(UserWarning):
    """A result is there, but not to be trusted without a look at what is said."""


class ComputationError(Error):
    """The computation failed (exit status 1): where, and what to try.

    run: what was written before, or None.
    """

    def __init__(self, message, run=None):
        super().__init__(message)
        self.run = run
