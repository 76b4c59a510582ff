# SPDX-License-Identifier: LGPL-2.1-or-later
"""What has been found of faults: a line of JSON for each as soon as it is known,
so that a campaign that was stopped goes on where it was.
"""
import hashlib
import json
import threading


def say(text):
    print(text, flush=True)


class Results:
    """Results of faults, in a file that is appended to.

    A result holds as long as the project and the entry of the fault are the
    same; that it survives the tests that it names says nothing of all others.
    """

    def __init__(self, path, digest, named_only):
        self.path, self.digest, self.named_only = path, digest, named_only
        self.lock, self.n_wanted, self.found = threading.Lock(), 0, {}
        lines = path.read_text().splitlines() if path.exists() else []
        for line in lines:
            result = json.loads(line)
            if result["noticed"] or named_only or result["by_all"]:
                self.found[result["key"]] = result

    def key(self, fault):
        text = self.digest + json.dumps([fault.name, fault.entries])
        return hashlib.sha256(text.encode()).hexdigest()

    def unknown(self, faults):
        """Those that have to be tried."""
        left = [fault for fault in faults if self.key(fault) not in self.found]
        self.n_wanted = len(left)
        return left

    def add(self, fault, test, as_named, seconds):
        """test: the name of the one that failed, or empty."""
        result = {"key": self.key(fault), "name": fault.name, "noticed": test,
                  "as_named": as_named, "by_all": not self.named_only,
                  "seconds": round(seconds, 1)}
        with self.lock:
            self.found[result["key"]] = result
            with open(self.path, "a") as file:
                file.write(json.dumps(result) + "\n")
            self.n_wanted -= 1
            say(f"{describe(fault, result)}  ({seconds:.0f} s, "
                f"{self.n_wanted} to go)")

    def summarise(self, faults):
        """A table; whether one survives that is not explained."""
        say(f"\n{'list':12} faults  noticed  no difference  explained  survive")
        rows = [(room, [fault for fault in faults if fault.room == room])
                for room in sorted({fault.room for fault in faults})]
        for room, some in [*rows, ("all", faults)]:
            left = [fault for fault in some if not self.is_noticed(fault)]
            equivalent = sum("equivalent" in fault.entries for fault in left)
            explained = sum(bool(fault.reason) for fault in left) - equivalent
            say(f"{room:12} {len(some):6} {len(some) - len(left):8} "
                f"{equivalent:14} {explained:10} "
                f"{len(left) - equivalent - explained:8}")
        open_ones = [fault.name for fault in faults
                     if not self.is_noticed(fault) and not fault.reason]
        if open_ones:
            say("survive without a reason: " + ", ".join(open_ones))
        return bool(open_ones)

    def is_noticed(self, fault):
        return bool(self.found[self.key(fault)]["noticed"])


def describe(fault, result):
    if result["noticed"]:
        return (f"noticed   {fault.name}  by {result['noticed']}" +
                ("" if result["as_named"] else ", which it does not name") +
                (", though the list explains it away" if fault.reason else ""))
    return f"SURVIVES  {fault.name}  " + (
        ("no difference: " if "equivalent" in fault.entries else "") +
        (" ".join(fault.reason.split()) or "not explained"))
