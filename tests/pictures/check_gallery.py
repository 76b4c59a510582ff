#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_gallery.py SOURCE_DIRECTORY

scripts/gallery makes what doc/gallery.md says. Stand-ins for the program and
for the scripts that draw write into each picture where it comes from. Then, for
every image of the page:
  scene      its parameter file and entries are those of a command scripts/run
             in the same or an earlier section (but title and fields interval)
  picture    the alternative text names the picture that it is, and of which
             experiment; --figure is that of a command scripts/plot
  factor     --scale is the number in the commands of its section, and the number in the
             text one of them
An image too many or too few is an error of scripts/gallery. The check is seen
to fail on faults in scripts/gallery.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

source = Path(sys.argv[1]).resolve()
n_failed = 0
PICTURES = {"Histories": "figure", "Contact": "contact", "Energy audit":
            "energy", "Decay of the energy": "decay", "Heat alone": "figure",
            "Elastic and rigid obstacle": "contact",
            "Sizes and errors of the steps": "steps",
            "Largest contact force": "peak", "largest contact force": "peak",
            "first contact": "first-contact", "End": "last",
            "Start of all experiments": "first",
            "Fields over space and time": "space-time",
            "Pressure and gap": "contact-face", "Key results": "results",
            "Time in contact": "results", "Each period": "bifurcation"}
STAND_IN = r"""#!/bin/sh
# Writes its arguments, a line each: the program into its output directory, a
# script into each of its pictures.
write() { printf '%s\n' "$@"; }
for word; do
  [ "${last:-}" = --output ] && output=$word
  last=$word
done
case ${0##*/} in
  program) mkdir -p "$output"; write "$@" >"$output/arguments" ;;
  plot) write plot "$@" >"$output" ;;
  paraview)
    mkdir "$1/paraview"
    for picture in first first-contact peak last space-time contact-face; do
      write paraview --picture "$picture" "$@" >"$1/paraview/$picture.png"
    done ;;
esac
"""


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


def make_tree(top, script, page):
    """A project with stand-ins, and a picture that is not made any more; runs its
    scripts/gallery."""
    shutil.rmtree(top, ignore_errors=True)
    (top / "scripts").mkdir(parents=True)
    (top / "doc/images/gallery").mkdir(parents=True)
    (top / "doc/images/gallery/old.png").touch()
    (top / "doc/gallery.md").write_text(page)
    for name, text in (("gallery", script), ("plot", STAND_IN), ("program",
                       STAND_IN), ("paraview", STAND_IN),
                       ("install_packages", "#!/bin/sh\n")):
        (top / "scripts" / name).write_text(text)
        (top / "scripts" / name).chmod(0o755)
    return subprocess.run(
        [top / "scripts/gallery"], capture_output=True, text=True, env={
            **os.environ, "THERMOCONTACT": str(top / "scripts/program")})


def arguments_of(file):
    """What is plain, and the values of options, of a list of arguments."""
    words, plain, options = file.read_text().splitlines(), [], {"--set": []}
    while words:
        word = words.pop(0)
        if word == "--set":
            options["--set"].append(words.pop(0))
        elif word.startswith("--") and word != "--quiet":
            options[word] = words.pop(0)
        elif word != "--quiet":
            plain.append(word)
    return plain, options


def origin_of(top, file):
    """Script, picture, factor and scenes that a picture comes from."""
    (kind, *names), options = arguments_of(file)
    scenes = [arguments_of(top / "build/gallery" / name / "arguments")
              for name in names]
    return {"kind": kind, "scale": options.get("--scale"), "picture":
            options.get("--picture", options.get("--figure")), "scenes": [
                [plain[-1].partition("/prm/")[2], more["--set"]]
                for plain, more in scenes]}


def without_output(settings):
    """Entries that change what is computed."""
    return sorted(entry for entry in settings if not re.match(
        r"Title=|Output/(Fields|Space-time) interval=", entry))


def commands_of(section):
    """Scenes of scripts/run, figures of scripts/plot, factors."""
    scenes, figures, scales = [], {"figure"}, set()
    for block in re.findall(r"^```sh\n(.*?)^```", section, flags=re.M | re.S):
        for line in block.replace("\\\n", " ").splitlines():
            words = shlex.split(line)
            values = [words[i + 1] for i, word in enumerate(words)
                      if word in ("--set", "--figure", "--scale")]
            if words[0] == "scripts/run":
                scenes.append([words[-1].partition("prm/")[2],
                               without_output(values)])
            elif words[0] == "scripts/plot":
                figures |= set(values) or {"figure", "contact", "energy"}
            elif words[0] == "scripts/paraview":
                scales |= set(values)
    return scenes, figures, scales


def faults_of_image(text, name, made, scenes, figures, scales):
    """made: see origin_of()"""
    faults = []
    kinds = [PICTURES[part] for part in re.split(", ", text)
             if part in PICTURES]
    if kinds != [made["picture"]]:
        faults.append(f"{text!r} is {made['picture']}")
    for prm, settings in made["scenes"]:
        if [prm, without_output(settings)] not in scenes:
            faults.append(f"{name}: no command has {prm} {settings}")
    number = re.search(r"experiment (\d)", text)
    if number and [prm for prm, _ in made["scenes"]] != [
            f"paper/experiment-{number[1]}.prm"]:
        faults.append(f"{text!r} is of {made['scenes']}")
    if made["kind"] == "plot" and made["picture"] not in figures:
        faults.append(f"{name}: no command has --figure {made['picture']}")
    if made["kind"] == "paraview" and scales != {made["scale"]}:
        faults.append(f"{name}: --scale {made['scale']}, not {scales}")
    return faults


def faults_of_page(top, page):
    faults, scenes, n_images, scales = [], [], 0, set()
    times = re.findall(r"drawn (\S+) times as large", page.replace("\n", " "))
    for section in re.split(r"^## ", page, flags=re.M):
        more, figures, more_scales = commands_of(section)
        scenes += more
        scales |= more_scales
        # what all experiments begin with is shown before the first of them
        known = scenes or commands_of(page)[0]
        for text, name in re.findall(r"!\[(.*?)\]\((images/gallery/.*?)\)",
                                     section):
            n_images += 1
            made = origin_of(top, top / "doc" / name)
            faults += faults_of_image(text, name, made, known, figures,
                                      more_scales or set(times))
    if len(times) != 1 or times[0] not in scales:
        faults.append(f"the text says {times} times, the commands {scales}")
    return faults if n_images else ["no images"]


def main(top):
    script = (source / "scripts/gallery").read_text()
    page = (source / "doc/gallery.md").read_text()
    result = make_tree(top, script, page)
    check("runs", result.returncode == 0, result.stderr.splitlines()[-1])
    n_images = len(re.findall(r"!\[", page))
    check("says how many", f"scripts/gallery: {n_images} pictures" in
          result.stdout, result.stdout)
    faults = faults_of_page(top, page)
    check("pictures of the page", not faults, "; ".join(faults[:5]))
    for old, new in (
            ("plot $name-history figure", "plot $name-history contact"),
            ("paper/$name.prm", "paper/experiment-1.prm"),
            ("plot figure-5 decay experiment-1 experiment-2",
             "plot figure-5 figure experiment-1 experiment-2"),
            ("plot rigid contact experiment-1 rigid",
             "plot rigid contact experiment-1 heat"),
            ("--scale 0.4", "--scale 0.8"), ("Mesh/Cells=8", "Mesh/Cells=16"),
            ("--set Dimension=3", "--set Dimension=2"),
            ("paraview/$picture.png\" ", "paraview/last.png\" "),
            ("first.png \"$pic", "last.png \"$pic"),
            ("heat-series", "heat-mode"), ("experiment-1-energy energy",
                                           "experiment-1-energy contact")):
        changed = script.replace(old, new)
        if old.startswith("plot rigid"):  # the scene has to be there
            changed = changed.replace("scene rigid", "scene heat verification/"
                                      "heat-mode.prm\nscene rigid").replace(
                "scene heat verification/heat-series", "true heat heat-series")
        result = make_tree(top, changed, page)
        check(f"fault noticed: {new}", changed != script and not
              result.returncode and faults_of_page(top, page))
    image = "![Heat alone](images/gallery/heat.png)\n"
    for name, changed, sign in (
            ("left out", page.replace(image, ""), ">"),
            ("not made", page + image.replace("heat.png", "cold.png"), "<")):
        result = make_tree(top, script, changed)
        check(f"refused: a picture {name}", result.returncode == 1 and re.search(
            rf"^{sign} images/gallery/(heat|cold).png$", result.stderr, re.M),
            result.stderr[-40:])


with tempfile.TemporaryDirectory() as scratch:
    main(Path(scratch) / "project")
sys.exit(1 if n_failed else 0)
