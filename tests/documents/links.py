# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: links.py PROJECT PROGRAM

Every link and image of the pages leads to a file, and to a heading in it.
"""
import subprocess
import sys
from pathlib import Path

project = Path(sys.argv[1])
pages = [*project.glob("*.md"), project / "doc", project / "tests"]
sys.exit(subprocess.run([project / "scripts/check_links", *pages]).returncode)
