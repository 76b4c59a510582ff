# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packages that a part of this module needs, and the others do not."""

import importlib

from .errors import Error


def optional_module(name, debian_package):
    """The module, or an Error that says what to install."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise Error(f"{error}: this needs {name.partition('.')[0]}\n  remedy:  apt install "
                    f"{debian_package}, or pip install {name.partition('.')[0]}") from error
