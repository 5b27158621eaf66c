"""The stubs declare the content of the module."""
import ast
import pathlib
import re
import subprocess
import sys
import unittest

import candela

STUBS = pathlib.Path(candela.__file__).with_name("__init__.pyi")
TREE = ast.parse(STUBS.read_text())
CLASSES = {node.name: node for node in TREE.body if isinstance(node, ast.ClassDef)}
FUNCTIONS = [node for node in TREE.body if isinstance(node, ast.FunctionDef)]


def options_of_help(text):
    """The options that the help of a function lists."""
    return set(re.findall(r"^  (\w+): ", text, re.MULTILINE))


def keywords(function):
    return {argument.arg for argument in function.args.kwonlyargs}


class Stubs(unittest.TestCase):
    def test_names(self):
        names = set(CLASSES) | {function.name for function in FUNCTIONS}
        public = {name for name in names if not name.startswith("_")} | {"__version__"}
        self.assertEqual(public, set(candela.__all__))

    def test_members(self):
        for name, node in CLASSES.items():
            if name.startswith("_") or issubclass(getattr(candela, name), BaseException | Warning):
                continue
            stated = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
            real = {member for member in vars(getattr(candela, name)) if not member.startswith("__") or member in stated}
            own = {member for member in real if not member.startswith("_pybind11")}
            self.assertEqual(stated, own, name)

    def test_options_of_functions(self):
        for name in ("load", "render", "merge", "verify", "explain", "compare"):
            stated = [keywords(function) - {"progress"} for function in FUNCTIONS if function.name == name]
            parts = getattr(candela, name).__doc__.split("\n\n")
            listed = [options_of_help(part) for part in parts if options_of_help(part)]
            self.assertEqual(stated, listed, name)

    def test_options_of_classes(self):
        own = {"Scene": {"normals", "texcoords", "colours", "lights", "camera", "name"}, "Session": set(), "Sequence": set()}
        for name, others in own.items():
            init = next(member for member in CLASSES[name].body if getattr(member, "name", "") == "__init__")
            listed = options_of_help(getattr(candela, name).__init__.__doc__)
            self.assertEqual(keywords(init) - others, listed, name)

    def test_types(self):
        script = "import candela\nfilm = candela.render(candela.load('a'), spp=4, size=(8, 8), samples=range(2))\nx: float = film.image[0, 0, 0]\n"
        script += ("import numpy\nscene = candela.Scene([[0.0]], [[0]], None, lights=None)\n"
                   "candela.render(scene, size=numpy.array([8, 8]), spp=numpy.int64(1), nee=numpy.bool_(True), crop=[0, 0, 4, 4])\n"
                   "candela.Session(scene).advance(numpy.int64(1))\nfilm.save(b'a.png', checkpoint=None, denoise=None)\n"
                   "candela.merge(name for name in ('a', 'b'))\n")
        wrong = ["candela.render(3)", "candela.load(4)", "film.save(checkpoint=3)", "film.hash + 1", "candela.render(scene, samplr='sobol')",
                 "candela.render(scene, sampler='halton')", "candela.compare(film)", "candela.Scene([[0]], [[0]], [{'rougness': 1}])"]
        setup = "import candela\nscene = candela.load('a')\nfilm = candela.render(scene)\n"
        self.assertEqual(self.mypy(script)[0], 0, self.mypy(script)[1])
        code, output = self.mypy(setup + "\n".join(wrong) + "\n")
        lines = {int(number) for number in re.findall(r"^<string>:(\d+): error", output, re.MULTILINE)}
        self.assertEqual((code, lines), (1, set(range(4, 4 + len(wrong)))), output)

    def mypy(self, script):
        done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir=/dev/null", "-c", script], capture_output=True, text=True,
                              check=False)
        return done.returncode, done.stdout + done.stderr


if __name__ == "__main__":
    unittest.main()
