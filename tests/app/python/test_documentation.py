"""The examples of docs/python.md run unchanged, with the output that they state."""
import contextlib
import io
import os
import re
import unittest

from support import SOURCE, FolderTest


class Documentation(FolderTest):
    def test_examples(self):
        text = (SOURCE / "docs/python.md").read_text()
        examples = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        self.assertGreater(len(examples), 7)
        (self.folder / "scenes").symlink_to(SOURCE / "scenes")
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        names = {}
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            for example in examples:
                exec(compile(example, "docs/python.md", "exec"), names)  # pylint: disable=exec-used
        for shown in ("(64, 64, 3) float32", 'spp: expected a whole number from 0 to 1073741824, got "-1"', "4 samples, noise",
                      "{'normal': (64, 64, 3), 'depth': (64, 64)}"):
            self.assertIn(shown, printed.getvalue())
        for file in ("cornell.png", "cornell.exr", "square.png", "part.film", "layers.exr", "denoised.png", "noisy.png"):
            self.assertGreater((self.folder / file).stat().st_size, 100)


if __name__ == "__main__":
    unittest.main()
