# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: readme.py PROJECT PROGRAM

Runs the commands of README.md, its blocks of sh, one after the other in a copy
of the project, and looks for the files that they promise: a comment that begins
with results/ names one. A block that begins with `# my.prm` is written to that
file. All but these are run as they stand:

  scripts/install_packages  replaced by nothing: the test installs nothing
  scripts/build             replaced by what says where PROGRAM is: it is built
  scripts/test              replaced by a check that bash can read it
  paraview FILE             replaced by a check that FILE is XML and the files
                            that it names exist
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

STUBS = {
    "scripts/install_packages": "exit 0",
    "scripts/build": 'if [ "$1" = --tree ]; then\n'
                     '  echo "$(cd "$(dirname "$0")/.." && pwd)/build/release"\n'
                     "fi",
    "scripts/test": 'exec bash -n "$PROJECT/scripts/test"',
    "bin/paraview": 'exec /usr/bin/python3 -c "\n'
                    "import sys, xml.etree.ElementTree as tree\n"
                    "from pathlib import Path\n"
                    "names = [e.get('file') for e in\n"
                    "         tree.parse(sys.argv[1]).iter('DataSet')]\n"
                    "assert names\n"
                    "for name in names:\n"
                    "    tree.parse(Path(sys.argv[1]).parent / name)\n"
                    '" "$1"',
}


def copy_project(project, program, top):
    """What the commands need, with what is not to be run replaced."""
    for name in ("scripts", "prm", "doc"):
        shutil.copytree(project / name, top / name)
    (top / "build/release").mkdir(parents=True)
    (top / "build/release/thermocontact").symlink_to(program)
    for name, text in STUBS.items():
        stub = top / name
        stub.parent.mkdir(exist_ok=True)
        stub.write_text("#!/bin/bash\n" + text + "\n")
        stub.chmod(0o755)


def main(project, program):
    environment = {**os.environ, "PROJECT": str(project)}
    blocks = re.findall(r"^```(\w*)\n(.*?)^```$",
                        (project / "README.md").read_text(), flags=re.M | re.S)
    n_commands, faults = 0, []
    with tempfile.TemporaryDirectory() as directory:
        top = Path(directory)
        copy_project(project, program, top)
        environment["PATH"] = f"{top}/bin:" + environment["PATH"]
        for language, block in blocks:
            if block.startswith("# my.prm\n"):
                (top / "my.prm").write_text(block)
            if language != "sh":
                continue
            for command in re.split(r"(?<!\\)\n", block.strip()):
                n_commands += 1
                begin = time.time()
                done = subprocess.run(["bash", "-c", command], cwd=top, text=True,
                                      env=environment, stdin=subprocess.DEVNULL,
                                      stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT)
                print(f"{time.time() - begin:5.1f} s  {command}")
                promised = re.search(r"# (results/\S+)$", command)
                if done.returncode != 0:
                    faults.append(f"{command}\n  exit status "
                                  f"{done.returncode}\n{done.stdout[-2000:]}")
                elif promised and not (top / promised.group(1)).exists():
                    faults.append(f"{command}\n  did not make that file")
    print(f"{n_commands} commands, {len(faults)} faults")
    print("\n".join(faults))
    return 1 if faults or n_commands < 5 else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()))
