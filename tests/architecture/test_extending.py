#!/usr/bin/env python3
"""Checks docs/extending.md: applies the first steps of recipes to a copy of the sources, and compiles what they change.

A feature flag and a lobe take one line each, a kind of primitives takes two. With these lines alone, everything that is
generated from the lists compiles, the compiler names the first place that must know the kind, and every kernel stays
the same but for the constants that it does not use, so that no image can change. The recipe of a surface parameter is
applied as a whole: its files are those that the page names, both compilers read the entry, and a kernel loads the
parameter only with its flag. The files, functions and constants that the page names exist.

Usage: test_extending.py COMPILER GLSLANG SPIRV_OPT [INCLUDE FOLDER...]
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMPILER, GLSLANG, SPIRV_OPT, *INCLUDES = sys.argv[1:]
LISTS = ("CANDELA_FEATURES", "CANDELA_PRIMITIVE_KINDS", "CANDELA_LOBES")
KIND_FLAG_ID = 1000


def append_entry(file, name, entry):
    """Appends an entry to the list `name`, a macro whose lines end in backslashes except for the last."""
    text = file.read_text()
    definition = re.search(rf"#define {name}\(X\)(?:.*\\\n)+.*\n", text)
    file.write_text(text[:definition.end() - 1] + " \\\n  " + entry + text[definition.end() - 1:])


def free_id(features):
    """Returns the id that features.h states to be free."""
    return int(re.search(r"\bid (\d+) is free", features.read_text())[1])


def apply_recipes(folder):
    """Copies the sources, and adds a flag, a kind of primitives with its flag, and a lobe."""
    for name in ("host", "lists", "shaders"):
        shutil.copytree(ROOT / name, folder / name)
    features = folder / "lists/features.h"
    flag_id = free_id(features)
    append_entry(features, "CANDELA_FEATURES", f"X(newFlag, kHasNewFlag, {flag_id})")
    append_entry(features, "CANDELA_FEATURES", f"X(newKinds, kHasNewKinds, {KIND_FLAG_ID})")
    append_entry(folder / "lists/primitive_kinds.h", "CANDELA_PRIMITIVE_KINDS",
                 "X(newKind, newKinds, kKindNew, 5u, kHasNewKinds)")
    append_entry(folder / "lists/lobes.h", "CANDELA_LOBES", "X(newLobe, kLobeNew, 8u)")
    return flag_id


# The steps of the recipe of a surface parameter: (file, text that occurs once in it, text that takes its place).
BOOST = (
    ("lists/surface_parameters.h", "  RECORD(kappa, ", "  RECORD(boost, kSurfaceBoost, 10u, kHasBoost) \\\n  RECORD(kappa, "),
    ("lists/surface_parameters.h", "  NUMBER(coatRoughness, ", "  NUMBER(specularBoost, 1, boost, x) \\\n  NUMBER(coatRoughness, "),
    ("host/trace/flatten/flatten_features.cpp", "  features.surfaces = true;\n",
     "  features.surfaces = true;\n  features.boosts |= surface.specularBoost != 1;\n"),
    ("host/trace/reference/surface_bsdf.cpp", "const double specular = ", "const double specular = double{surface.specularBoost} * "),
    ("shaders/surface.glsl", "  float diffuse = luminance(", "  if (kHasBoost) specular *= s.specularBoost;\n  float diffuse = luminance("),
    ("host/formats/gltf/gltf_material.h", "  double clearcoat = 0;", "  double specularBoost = 1;\n  double clearcoat = 0;"),
    ("host/formats/gltf/gltf_material.cpp", "  result.clearcoat = ",
     '  result.specularBoost = atLeastZero(*coat, "specularBoost", 1);\n  result.clearcoat = '),
    ("host/formats/gltf/material_mapping.cpp", "  surface.coatWeight = ",
     "  surface.specularBoost = static_cast<float>(source.specularBoost);\n  surface.coatWeight = "))


def apply_boost(folder):
    """Copies the sources, and adds the parameter of the recipe. Returns the id of its flag and the files that changed."""
    for name in ("host", "lists", "shaders"):
        shutil.copytree(ROOT / name, folder / name)
    features = folder / "lists/features.h"
    flag_id = free_id(features)
    append_entry(features, "CANDELA_FEATURES", f"X(boosts, kHasBoost, {flag_id})")
    for file, old, new in BOOST:
        text = (folder / file).read_text()
        assert text.count(old) == 1, (file, old)
        (folder / file).write_text(text.replace(old, new))
    return flag_id, {"lists/features.h", *(file for file, _, _ in BOOST)}


def check_syntax(folder, files, text=None):
    """Compiles without writing code; `text` is the source if there are no files."""
    includes = [f"-I{include}" for include in (folder, *INCLUDES)]
    source = [str(folder / file) for file in files] if text is None else ["-x", "c++", "-"]
    return subprocess.run([COMPILER, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", *includes, *source],
                          input=text, capture_output=True, text=True)


def kernel_without(folder, shader, flag_ids, out):
    """Returns the SPIR-V of a shader whose specialisation constants have their defaults, except that the flags of
    these ids are false. It has no names, and no constants that are unused or stored twice."""
    subprocess.run([GLSLANG, "--quiet", "--target-env", "vulkan1.2", f"-I{folder / 'shaders'}", "-o", out,
                    folder / "shaders" / shader], check=True)
    values = " ".join(f"{flag_id}:false" for flag_id in flag_ids)
    subprocess.run([SPIRV_OPT, *([f"--set-spec-const-default-value={values}"] if values else []), "--freeze-spec-const",
                    "--fold-spec-const-op-composite", "--strip-debug", "--unify-const", "--eliminate-dead-const",
                    "--compact-ids", out, "-o", out], check=True)
    return Path(out).read_bytes()


def named_things(page):
    """Returns the code spans of a page that are names of files, functions or constants, without placeholders."""
    spans = {span for span in re.findall(r"`([^`\n]+)`", page) if "..." not in span and "NAME" not in span}
    files = {span for span in spans if re.fullmatch(r"[\w/]+\.(?:cpp|h|glsl|comp|md|toml|py|txt)", span)}
    folders = {span for span in spans if re.fullmatch(r"(?:host|lists|shaders|tests|scenes)/[\w/]*", span)}
    words = {span.removesuffix("()").split("::")[-1] for span in spans
             if re.fullmatch(r"[\w:]+\(\)|(?:\w+::)+\w+|k[A-Z]\w+|CANDELA_\w+", span)}
    return files, folders, words


class Page(unittest.TestCase):
    def test_everything_that_is_named_exists(self):
        files, folders, words = named_things((ROOT / "docs/extending.md").read_text())
        self.assertTrue(len(files) > 50 and len(words) > 30, (files, words))
        sources = [file for name in ("host", "lists", "shaders", "tests", "docs", "scenes") for file in (ROOT / name).rglob("*")]
        names = {file.name for file in sources}
        code = {word for file in sources if file.suffix in (".h", ".cpp", ".glsl", ".comp", ".txt")
                for word in re.findall(r"\w+", file.read_text())}
        code |= {word for file in (ROOT / "cmake").glob("*.cmake") for word in re.findall(r"\w+", file.read_text())}
        self.assertEqual([name for name in sorted(files)
                          if not ((ROOT / name).exists() if "/" in name else name in names)], [])
        self.assertEqual([name for name in sorted(folders) if not (ROOT / name).is_dir()], [])
        self.assertEqual(sorted(words - code), [])


    def test_functions_are_in_the_files_that_are_named(self):
        page = (ROOT / "docs/extending.md").read_text()
        pairs = re.findall(r"`(?:\w+::)*(\w+)(?:\(\))?`\s+(?:in|\()\s*`([\w/]+/[\w/]+\.\w+)`", page)
        self.assertGreater(len(pairs), 30)
        self.assertEqual([(name, file) for name, file in pairs
                          if not re.search(rf"\b{name}\b", (ROOT / file).read_text())], [])


class Recipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="candela-test-")
        cls.folder = Path(cls.temporary.name)
        cls.flag_id = apply_recipes(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_code_generated_from_the_lists_compiles(self):
        use = re.compile(rf"\b(?:{'|'.join(LISTS)})\(")
        files = [file.relative_to(ROOT) for file in sorted((ROOT / "host").rglob("*.cpp")) if use.search(file.read_text())]
        self.assertGreater(len(files), 3)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            results = list(pool.map(lambda file: check_syntax(self.folder, [file]), files))
        for file, result in zip(files, results):
            with self.subTest(file=str(file)):
                self.assertEqual(result.returncode, 0, result.stderr)

    def test_compiler_names_the_place_that_lacks_the_kind(self):
        shapes = '#include "host/scene/shape.h"\n'
        self.assertEqual(check_syntax(ROOT, [], shapes).returncode, 0)
        result = check_syntax(self.folder, [], shapes)
        self.assertNotEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"host/scene/shape\.h:\d+:\d+: error: .*newKind")

    def test_kernels_stay_the_same(self):
        shaders = [file.name for file in sorted((ROOT / "shaders").glob("*.comp"))]
        self.assertIn("path.comp", shaders)

        def both(shader):
            out = self.folder / shader
            before = kernel_without(ROOT, shader, [], f"{out}.before.spv")
            return before == kernel_without(self.folder, shader, [self.flag_id, KIND_FLAG_ID], f"{out}.after.spv")

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            self.assertEqual([shader for shader, same in zip(shaders, pool.map(both, shaders)) if not same], [])


class SurfaceParameter(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="candela-test-")
        cls.folder = Path(cls.temporary.name)
        cls.flag_id, cls.files = apply_boost(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_page_names_the_files_that_change(self):
        recipe = (ROOT / "docs/extending.md").read_text().split("## A surface parameter")[1].split("\n## ")[0]
        steps = recipe.split("`tests/architecture")[0]
        self.assertEqual(set(re.findall(r"`((?:host|lists|shaders)/[\w/]+\.\w+)`", steps)), self.files)
        self.assertIn("It takes eight files", recipe)
        self.assertEqual(len(self.files), 8)

    def test_both_compilers_read_the_entry(self):
        sources = sorted({file for file in self.files if file.endswith(".cpp")} | {"host/trace/flatten/flatten_surfaces.cpp"})
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            results = list(pool.map(lambda file: check_syntax(self.folder, [file]), sources))
        for file, result in zip(sources, results):
            with self.subTest(file=file):
                self.assertEqual(result.returncode, 0, result.stderr)

    def test_kernel_reads_the_parameter_only_with_its_flag(self):
        def live_size(flags):
            out = str(self.folder / "path.comp.spv")
            kernel_without(self.folder, "path.comp", flags, out)
            subprocess.run([SPIRV_OPT, "--eliminate-dead-branches", "--eliminate-dead-code-aggressive", out, "-o", out],
                           check=True)
            return Path(out).stat().st_size

        self.assertLess(live_size([self.flag_id]), live_size([]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
