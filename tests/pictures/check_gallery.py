#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_gallery.py SOURCE_DIRECTORY

scripts/gallery makes the pictures of doc/gallery.md. Stand-ins for the program and
for the scripts that draw write into each picture where it comes from; then every
image of the page that names an experiment is of that experiment, and one that names
a picture is that picture. An image too many or too few is an error of the script.
"""
import os
import re
import sys
import subprocess
import tempfile
from pathlib import Path

source = Path(sys.argv[1]).resolve()
n_failed = 0
PICTURES = {"Contact": "contact", "Energy audit": "energy", "Decay of the energy": "decay",
            "Largest contact force": "peak", "First contact": "first-contact",
            "Fields over space and time": "space-time", "Each period": "bifurcation"}
STAND_IN = r"""#!/bin/sh
# Writes its arguments: the program into its output directory, a script into each of
# its pictures.
for word; do
  [ "${last:-}" = --output ] && output=$word
  last=$word
done
case ${0##*/} in
  program) mkdir -p "$output"; echo "$*" >"$output/arguments" ;;
  plot) echo "plot $*" >"$output" ;;
  paraview)
    mkdir "$1/paraview"
    for picture in first first-contact peak last space-time contact-face; do
      echo "paraview --figure $picture $*" >"$1/paraview/$picture.png"
    done ;;
esac
"""


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


def run_gallery(top, page):
    """In a project with stand-ins, and a picture that is not made any more."""
    (top / "scripts").mkdir(parents=True)
    (top / "doc/images/gallery").mkdir(parents=True)
    (top / "doc/images/gallery/old.png").touch()
    (top / "doc/gallery.md").write_text(page)
    script = (source / "scripts/gallery").read_text()
    for name, text in (("gallery", script), ("plot", STAND_IN), ("program", STAND_IN),
                       ("paraview", STAND_IN), ("install_packages", "#!/bin/sh\n")):
        (top / "scripts" / name).write_text(text)
        (top / "scripts" / name).chmod(0o755)
    return subprocess.run([top / "scripts/gallery"], capture_output=True, text=True,
                          check=False, env={**os.environ, "THERMOCONTACT": str(
                              top / "scripts/program")})


def main(top):
    page = (source / "doc/gallery.md").read_text()
    result = run_gallery(top / "whole", page)
    images = re.findall(r"!\[(.*?)\]\((images/gallery/.*?)\)", page)
    check("runs", result.returncode == 0 and
          f"scripts/gallery: {len(images)} pictures" in result.stdout, result.stderr)
    for text, name in images:
        words = (top / "whole/doc" / name).read_text().split()
        scenes = [(top / "whole/build/gallery" / word / "arguments").read_text()
                  for word in words if (top / "whole/build/gallery" / word).is_dir()]
        number = re.search(r"experiment (\d)", text)
        kind = PICTURES.get(text.partition(",")[0])
        check(text, scenes and (not number or all(
            f"paper/experiment-{number[1]}.prm" in scene for scene in scenes)) and
            (not kind or words[words.index("--figure") + 1] == kind), " ".join(words))
    image = "![Heat alone](images/gallery/heat.png)\n"
    for name, changed, sign in (
            ("left out", page.replace(image, ""), ">"),
            ("not made", page + image.replace("heat.png", "cold.png"), "<")):
        result = run_gallery(top / name.split()[-1], changed)
        check(f"refused: a picture {name}", result.returncode == 1 and re.search(
            rf"^{sign} images/gallery/(heat|cold).png$", result.stderr, re.M),
            result.stderr[-40:])


with tempfile.TemporaryDirectory() as scratch:
    main(Path(scratch))
sys.exit(1 if n_failed else 0)
