#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""usage: check_scripts.py SOURCE_DIRECTORY

What scripts/check_links, scripts/build, scripts/run, scripts/mutate, scripts/bare,
.ci/run and scripts/gallery report. The links of a small page, one by one, lead somewhere or
not, as written beside each; the counts in the last line are those of the page.
The others run in a project whose cmake, make, mpirun, program and packages are
stand-ins that write down their arguments, and fail when told to: messages, logs,
exit status, what is passed on.
"""
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

source = Path(sys.argv[1]).resolve()
n_failed = 0
PAGE = """# One title
[inside](#one-title), twice below

## Twice
## Twice
## `Code` and (brackets), a_b
"""
# Markdown, and what is said of its link; None: it leads somewhere, "": no link.
LINKS = [
    ("[a](page.md)", None), ("[a](page.md#one-title)", None),
    ("[a](page.md#twice-1)", None), ("[a](page.md#twice-2)", "heading"),
    ("[a](page.md#code-and-brackets-a_b)", None), ("[a](#here)", None),
    ("[a](#there)", "heading"), ("[a](page.md#One-title)", "heading"),
    ("[a](pages.md)", "file"), ("![a](picture.png)", None),
    ("![a](pictures.png)", "file"), ("[a](folder)", None),
    ("[a](<page.md>)", None), ("[a](with%20space.md)", None),
    ("[a](page.md?raw=1)", None), ("[a](folder/../page.md \"title\")", None),
    ("[a](https://nowhere.invalid/x)", ""), ("[a](mailto:a@b)", ""),
    ("`[a](pages.md)`", ""), ("```\n[a](pages.md)\n```", ""),
    ("[![a](pictures.png)](page.md)", "file"),
    ("[![a](picture.png)](pages.md)", "file")]
HTML = [('<a href="page.html#top">', None), ("<a href='page.html#low'>", None),
        ('<a href="page.html#side">', "heading"), ('<img src="x.png">', "file"),
        ('<a href="page.html?a=1&amp;b=2">', None),
        ('<script>"<a href="x.html">"</script>', ""),
        ('<a href="//nowhere.invalid">', "")]
STAND_IN = """#!/bin/sh
name=${0##*/}
echo "$name $*" >>"$CALLS"
[ "$name" != cmake ] || while [ "$1" != -B ]; do shift; done
[ "$name" != cmake ] || touch "$2/Makefile"
case " $FAIL " in
  *" $name "*) seq 30; echo "$WORDS"; exit 1 ;;
esac
[ "$name" != thermocontact ] || exit "${STATUS:-0}"
"""
# mpirun with a rank that has a signal sent to scripts/run
SIGNALLED = """#!/bin/bash
(trap 'echo rank TERM >>"$CALLS"; exit 4' TERM
kill -"$SIGNAL" $PPID
for i in {1..300}; do sleep 0.1; done) &
trap 'echo mpirun >>"$CALLS"' INT TERM HUP
wait $!
"""


def heed_signals():
    """For scripts that shells would not let heed them: this one may be in the background."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def check(name, good, message=""):
    global n_failed
    n_failed += not good
    print(f"{'passed' if good else 'FAILED'}: {name}  {message}".rstrip())


def links_in(folder, *paths):
    return subprocess.run([source / "scripts/check_links", *paths], cwd=folder,
                          capture_output=True, text=True)


def check_one_link(folder, file, text, fault):
    """A page with a link that leads somewhere, and this one."""
    good = "[a](page.md)" if file.suffix == ".md" else '<a href="page.html">'
    file.write_text(f"# Here\n{good}\n\n{text}\n")
    result = links_in(folder, file.name)
    n_links = 1 + text.count("](") if file.suffix == ".md" else 2
    n_links = 1 if fault == "" else n_links
    name = re.findall(r"\]\(<?([^)\s>]+)|(?:href|src)=.([^\"']*)", text)
    wanted = [f"{file.name}: {''.join(link)}: no such {fault}" for link in name] \
        if fault else []
    lines = result.stderr.splitlines()
    check(f"link {text!r}", result.returncode == bool(fault) and
          len(lines) == bool(fault) and set(lines) <= set(wanted) and
          result.stdout == f"1 files, {n_links} links, {len(lines)} lead "
          "nowhere\n", f"{result.stdout.strip()} {result.stderr.strip()}")


def check_links(folder):
    folder.mkdir()
    (folder / "folder").mkdir()
    for name in ("picture.png", "with space.md"):
        (folder / name).touch()
    (folder / "page.md").write_text(PAGE)
    (folder / "page.html").write_text('<p id="top"><a name="low">')
    for text, fault in LINKS:
        check_one_link(folder, folder / "test.md", text, fault)
    for text, fault in HTML:
        check_one_link(folder, folder / "test.html", text, fault)
    (folder / "test.html").unlink()
    (folder / "test.md").write_text("[a](no.md) [b](page.md)")
    (folder / "folder/deep.md").write_text("[a](../page.md) [b](page.md)")
    result = links_in(folder, ".")
    # test 2, deep 2, page 1 and no link in "with space.md" and page.html
    check("links of a folder", result.returncode == 1 and result.stdout ==
          "5 files, 5 links, 2 lead nowhere\n", result.stdout)
    (folder / "test.md").write_text("no link")
    check("links: none at all", links_in(folder, "test.md").returncode == 1)


class Project:
    """A project with scripts/build and scripts/run, and stand-ins."""

    def __init__(self, top):
        self.top, self.calls = top, top / "calls"
        (top / "scripts").mkdir(parents=True)
        (top / "bin").mkdir()
        for name in ("build", "run"):
            shutil.copy(source / "scripts" / name, top / "scripts")
        for name in ("cmake", "make", "mpirun"):
            self.stand_in(top / "bin" / name)
        self.stand_in(top / "scripts/install_packages")

    def stand_in(self, path, text=STAND_IN):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)

    def run(self, script, *arguments, **environment):
        """Result, and the calls of the stand-ins."""
        self.calls.write_text("")
        clean = {key: value for key, value in os.environ.items()
                 if not key.startswith(("OMPI_", "NRANKS", "MAKE"))}
        result = subprocess.run(
            [self.top / "scripts" / script, *arguments], capture_output=True,
            text=True, env={**clean, "CALLS": str(self.calls), "PATH":
                            f"{self.top}/bin:{os.environ['PATH']}",
                            **environment}, preexec_fn=heed_signals)
        return result, self.calls.read_text().splitlines()


def check_build(top):
    project = Project(top)
    tree = top / "build/release"
    for words, shown in (("CMake Error at 5", "31:CMake Error at 5"),
                         ("no such compiler", "no such compiler")):
        result, calls = project.run("build", "Release", FAIL="cmake",
                                    WORDS=words)
        check(f"configuring fails, {words}", result.returncode == 1 and
              result.stderr.splitlines()[0] == f"scripts: configuring {tree}"
              and shown in result.stderr.splitlines() and
              f"configuring failed; its log: {tree}/build.log" in result.stderr
              and len(calls) == 1 and "-DCMAKE_BUILD_TYPE=Release" in calls[0]
              and not (tree / "Makefile").exists(), result.stderr)
    for words, shown in (("a.cc:3: error: x", "31:a.cc:3: error: x"),
                         ("No rule to make target", "No rule to make target")):
        result, calls = project.run("build", "Release", FAIL="make",
                                    WORDS=words)
        lines = result.stderr.splitlines()
        check(f"building fails, {words}", result.returncode == 1 and
              "scripts: building (Release), a few minutes" in lines and
              shown in lines and lines[-1] == "scripts: building failed; "
              f"its log: {tree}/build.log", result.stderr)
    project.stand_in(tree / "libthermocontact.a")
    result, calls = project.run("build", "Release")
    check("nothing to build", result.returncode == 0 and not result.stderr and
          not result.stdout and len(calls) == 1 and re.fullmatch(
              rf"make -C {tree} -j\d+ thermocontact", calls[0]), str(calls))
    result, calls = project.run("build", "Debug", "one", "two")
    check("Debug, targets", result.returncode == 0 and len(calls) == 2 and
          f"-B {top}/build/debug" in calls[0] and
          "-DCMAKE_BUILD_TYPE=Debug" in calls[0] and
          calls[1].startswith(f"make -C {top}/build/debug -j") and
          calls[1].endswith(" one two"), str(calls))
    (tree / "CMakeCache.txt").write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={top}\n")
    (tree / "Makefile").write_text("one:\n")
    for target, expected in (("one", ["make"]), ("new", ["cmake", "make"])):
        result, calls = project.run("build", "Release", target)
        check(f"configured here, {target}", [call.split()[0] for call in calls] ==
              expected, str(calls))
    result, calls = project.run("build", "Release", MAKEFLAGS="--jobserver-auth=3,4")
    check("jobs of make", calls == [f"make -C {tree} thermocontact"], str(calls))
    (tree / "CMakeCache.txt").write_text("CMAKE_HOME_DIRECTORY:INTERNAL=/else\n")
    result, calls = project.run("build", "Release")
    check("configured elsewhere", [call.split()[0] for call in calls] ==
          ["cmake", "make"] and not (tree / "CMakeCache.txt").exists(), str(calls))
    result, calls = project.run("build", "--tree", "Debug")
    check("the tree", result.stdout == f"{top}/build/debug\n" and not calls,
          result.stdout)
    for arguments in ((), ("release",)):
        result, calls = project.run("build", *arguments)
        check(f"refused: {arguments}", result.returncode == 2 and not calls and
              "usage: scripts/build Release|Debug" in result.stderr,
              result.stderr)


def check_foreign_clone(top):
    """A clone that cannot be written by who builds, or where somebody else has built:
    all of it, its trees, one of them. Root may write everywhere and is nobody here."""
    Project(top)
    as_nobody = {"user": 65534, "group": 65534} if os.getuid() == 0 else {}
    top.parent.chmod(0o755)  # of the scratch directory of root
    (top / "build/release").mkdir(parents=True)
    folders = (top, top / "build", top / "build/release", top / "build/debug")
    for closed, n_elsewhere in ((folders[0], 2), (folders[1], 2), (folders[2], 1), (None, 0)):
        for folder in folders[:3]:
            folder.chmod(0o555 if folder == closed else 0o777)
        trees = [subprocess.run(
            [top / "scripts/build", "--tree", name], capture_output=True, text=True,
            check=False, env={**os.environ, "XDG_CACHE_HOME": "/somewhere"},
            **as_nobody).stdout.strip() for name in ("Release", "Debug")]
        elsewhere = [tree for tree in trees if tree.startswith("/somewhere/thermocontact/")]
        check(f"a clone that cannot be written, {closed and closed.relative_to(top.parent)}",
              len(elsewhere) == n_elsewhere and elsewhere == trees[:n_elsewhere] and
              [Path(tree).name for tree in trees] == ["release", "debug"] and
              trees[n_elsewhere:] == [str(f) for f in folders[2 + n_elsewhere:]], str(trees))
    for folder in folders[:3]:
        folder.chmod(0o755)


def check_gallery(top):
    """The pictures of doc/gallery.md are those that the script makes, of scenes that are there.
    Stand-ins make the picture that they are told, or all that are shown of a run."""
    project, page = Project(top), top / "doc/gallery.md"
    page.parent.mkdir()
    text = (source / "doc/gallery.md").read_text()
    shown = sorted(set(re.findall(r"images/gallery/([^)]*)", text)))
    shutil.copy(source / "scripts/gallery", top / "scripts")
    (top / "prm").symlink_to(source / "prm")
    for name, lines in {
            "plot": 'while [ "$1" != --output ]; do shift; done; touch "$2"',
            "paraview": 'name=${1##*/}; mkdir -p "$1/paraview"\nfor picture in ' +
                        " ".join(shown) + '; do\ncase $picture in $name-*) '
                        'touch "$1/paraview/${picture#$name-}" ;; esac; done',
            "scene": 'for file; do :; done; test -f "$file"; mkdir -p "$3"'}.items():
        project.stand_in(top / "scripts" / name)
        (top / "scripts" / name).write_text(f"#!/bin/sh\nset -e\n{lines}\n")
    for what, words, status in (
            ("as it is", text, 0), ("one more", text + "![](images/gallery/x.png)", 1),
            ("one less", re.sub(r"\S*images/gallery/" + shown[0] + r"\S*", "", text), 1)):
        page.write_text(words)
        result, _ = project.run("gallery", THERMOCONTACT=str(top / "scripts/scene"))
        check(f"gallery, {what}", result.returncode == status and
              (f"{len(shown)} pictures" if status == 0 else "differ") in
              result.stdout + result.stderr, result.stderr[-300:])


def check_help():
    for script in sorted((source / "scripts").iterdir()):
        if os.access(script, os.X_OK):
            result = subprocess.run([script, "--help"], capture_output=True, text=True)
            # scripts/run shows the help of the program, if it is built
            name = "thermocontact" if script.name == "run" else script.name
            check(f"{script.name} --help", result.returncode == 0 and (
                f"scripts/{script.name}" in result.stdout or
                f"sage: {name}" in result.stdout) and not result.stderr,
                  result.stderr)


def check_installed(top):
    """cmake/script.in, as cmake/install.cmake puts it beside the scripts: names, what is missing"""
    shutil.copytree(source / "scripts", top / "share/scripts")
    (top / "bin").mkdir()
    without = top / "without"
    without.mkdir()
    for module in ("numpy", "matplotlib"):
        (without / f"{module}.py").write_text(f"raise ImportError('no {module}')\n")
    (top / "contact.csv").write_text("time,displacement_end\n0,0\n")
    template = (source / "cmake/script.in").read_text()
    for name, package in (("plot", "python3-matplotlib"), ("paraview", "python3-numpy")):
        installed = top / "bin" / f"thermocontact-{name}"
        (top / "share/scripts" / installed.name).symlink_to(name)
        text = template.replace("@script@", f"../share/scripts/{installed.name}")

        def call(*arguments, python="/usr/bin/python3", path=os.environ["PATH"], **environment):
            installed.write_text(text.replace("/usr/bin/python3", python))
            installed.chmod(0o755)
            return subprocess.run([installed, *arguments], capture_output=True, text=True,
                                  check=False, env={**os.environ, "PATH": path, **environment})

        result = call("--help")
        check(f"{installed.name} --help", result.returncode == 0 and
              result.stdout.startswith(f"usage: {installed.name} ") and
              f"scripts/{name}" not in result.stdout, result.stderr)
        result = call()
        check(f"{installed.name} without DIR", result.returncode == 2 and
              result.stderr.startswith(f"{installed.name}: "), result.stderr)
        result = call(str(top), PYTHONPATH=str(without))
        check(f"{installed.name} without {package}", result.returncode == 2 and
              len(result.stderr.splitlines()) == 1 and
              result.stderr.startswith(f"{installed.name}: ") and
              f"install Debian's {package}" in result.stderr, result.stderr)
        result = call(str(top), python="/nonexistent/python3", path=str(without))
        check(f"{installed.name} without Python", result.returncode == 2 and result.stderr ==
              f"{installed.name}: python3 is not there; install Debian's python3\n",
              result.stderr)


def check_mutate(top):
    """Without the syntax tree, whose package nothing but scripts/mutate needs: it shows its help,
    installs the package, and says what to install by hand where the module is missing all the same."""
    project = Project(top)
    shutil.copy(source / "scripts/mutate", top / "scripts")
    shutil.copytree(source / "tests/mutate", top / "tests/mutate")
    (top / "clang.py").write_text("raise ImportError('no clang')\n")
    without = {"PYTHONPATH": str(top)}
    result, calls = project.run("mutate", "--help", **without)
    check("mutate --help without clang", result.returncode == 0 and not calls and
          "usage: scripts/mutate" in result.stdout and not result.stderr, result.stderr)
    result, calls = project.run("mutate", "1", "1", **without)
    check("mutate without clang", result.returncode == 1 and len(calls) == 1 and
          "python3-clang" in calls[0].split() and result.stderr ==
          "scripts/mutate: no clang; install Debian's python3-clang\n", result.stderr)
    result, calls = project.run("mutate", "1", "1", FAIL="install_packages", WORDS="what")
    check("mutate, installing fails", result.returncode == 1 and len(calls) == 1 and
          not result.stderr, result.stderr)


def check_ci(top):
    """Both suites in bare systems that say what they are told: the lines of their results stand at
    the end, one that fails is a failure, and without bare systems the tests run here."""
    project = Project(top)
    (top / ".ci").mkdir()
    shutil.copy(source / ".ci/run", top / ".ci")
    for name, said in (("bare", "scripts/test: $WORD, 7 s"), ("test", "of this system")):
        project.stand_in(top / "scripts" / name)
        (top / "scripts" / name).write_text(
            f"#!/bin/sh\nsuite=${{1:-here}}\n[ $suite != --root ] || suite=$2\necho {name} $suite >>$CALLS\n"
            f'WORD=passed\n[ "$suite" != "$RED" ] || WORD=FAILED\necho "{said}"\n'
            'echo "100% tests passed, 0 tests failed out of 3"\necho "scripts/bare: no $suite"\n'
            f'[ $WORD = passed ] || exit 1\n[ {name} = test ] || exit $STATUS\n')
    passed = "100% tests passed, 0 tests failed out of 3"
    for red, status, suites in (("", "0", ["bookworm", "trixie"]), ("trixie", "0", []),
                                ("bookworm", "0", []), ("", "125", []), ("", "3", [])):
        result, calls = project.run("../.ci/run", RED=red, STATUS=status)
        expected = []
        for suite in ("bookworm", "trixie"):
            expected += [f"== {suite}", f"scripts/test: {'FAILED' if red == suite else 'passed'}, 7 s",
                         passed] + ["scripts/bare: no " + suite] * (status == "125")
        if status == "125":
            expected += ["== scripts/test in this system instead", passed]
        check(f"CI, red {red!r}, status {status}", result.returncode == (
            0 if not red and status in ("0", "125") else 1) and
            result.stdout.rstrip().splitlines()[-len(expected):] == expected and
            calls == ["bare bookworm", "bare trixie"] + ["test here"] * (status == "125"),
            result.stdout + result.stderr)


def check_bare():
    """What scripts/bare refuses before it makes anything."""
    script = source / "scripts/bare"
    for words, status in (((), 2), (("trixie",), 2), (("--no", "x"), 2), (("a/b", "true"), 2)):
        result = subprocess.run([script, *words], capture_output=True, text=True, check=False)
        check(f"bare {words}", result.returncode == status and not result.stdout and
              "usage: scripts/bare" in result.stderr, result.stderr)
    as_nobody = {"user": 65534, "group": 65534} if os.getuid() == 0 else {}
    result = subprocess.run(["bash", "-s", "trixie", "true"], input=script.read_text(),
                            capture_output=True, text=True, check=False, cwd="/", **as_nobody)
    check("bare, as somebody", result.returncode == 125 and result.stderr ==
          "scripts/bare: no bare trixie here: only root can make it\n", result.stderr)


def check_run(top):
    project = Project(top)
    result, calls = project.run("run", "--help")
    check("help without a build", result.returncode == 0 and not calls and
          "usage: scripts/run" in result.stdout, result.stdout)
    program = top / "build/release/thermocontact"
    project.stand_in(program)
    result, calls = project.run("run", "--set", "a b=c", "x.prm", STATUS="3")
    check("one process", result.returncode == 3 and [
        call.split()[0] for call in calls] == [
            "install_packages", "cmake", "make", "thermocontact"] and
        calls[-1] == "thermocontact --set a b=c x.prm", str(calls))
    result, calls = project.run("run", "x.prm", NRANKS="2")
    root = "--allow-run-as-root " if os.getuid() == 0 else ""
    check("two ranks", result.returncode == 0 and calls[-1] ==
          f"mpirun {root}--oversubscribe -n 2 {program} x.prm", str(calls))
    project.stand_in(top / "bin/mpirun", SIGNALLED)
    for name in ("INT", "TERM", "HUP"):
        result, calls = project.run("run", "x.prm", NRANKS="2", SIGNAL=name)
        check(f"{name} is for the ranks", result.returncode == 4 and
              calls[-1] == "rank TERM", f"{result} {calls}")
    project.stand_in(top / "bin/mpirun")
    for name, what in (("install_packages", []), ("make", ["make"])):
        result, calls = project.run("run", "x.prm", FAIL=name, WORDS="error")
        check(f"{name} fails", result.returncode == 1 and
              calls[-1].startswith(name), str(calls))


with tempfile.TemporaryDirectory() as scratch:
    check_links(Path(scratch) / "links")
    check_build(Path(scratch) / "build of")
    check_run(Path(scratch) / "run of")
    check_mutate(Path(scratch) / "mutate of")
    check_ci(Path(scratch) / "ci of")
    check_foreign_clone(Path(scratch) / "foreign")
    check_installed(Path(scratch) / "installed")
    check_gallery(Path(scratch) / "gallery of")
check_bare()
check_help()
sys.exit(1 if n_failed else 0)
