"""What the stand-in received and decided: one JSON object per line."""
import json
import time


class Journal:
    def __init__(self, path):
        self.file = open(path, "w", buffering=1) if path else None
        self.start = time.monotonic()

    def note(self, kind, **values):
        if self.file is not None:
            entry = {"wall_s": round(time.monotonic() - self.start, 3), "kind": kind, **values}
            self.file.write(json.dumps(entry) + "\n")
