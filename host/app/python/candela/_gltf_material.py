"""Materials by their parameters, with the meaning of glTF."""
import math
from collections.abc import Mapping

import numpy

from ._errors import UsageError

_CORE = "pbrMetallicRoughness"
# Each entry: the object of glTF that has it, its name there, and the number of its components.
_ENTRIES = {
    "base_colour": (_CORE, "baseColorFactor", 3),
    "metallic": (_CORE, "metallicFactor", 1),
    "roughness": (_CORE, "roughnessFactor", 1),
    "ior": ("KHR_materials_ior", "ior", 1),
    "specular": ("KHR_materials_specular", "specularFactor", 1),
    "specular_colour": ("KHR_materials_specular", "specularColorFactor", 3),
    "transmission": ("KHR_materials_transmission", "transmissionFactor", 1),
    "thickness": ("KHR_materials_volume", "thicknessFactor", 1),
    "attenuation_colour": ("KHR_materials_volume", "attenuationColor", 3),
    "attenuation_distance": ("KHR_materials_volume", "attenuationDistance", 1),
    "dispersion": ("KHR_materials_dispersion", "dispersion", 1),
    "clearcoat": ("KHR_materials_clearcoat", "clearcoatFactor", 1),
    "clearcoat_roughness": ("KHR_materials_clearcoat", "clearcoatRoughnessFactor", 1),
    "sheen_colour": ("KHR_materials_sheen", "sheenColorFactor", 3),
    "sheen_roughness": ("KHR_materials_sheen", "sheenRoughnessFactor", 1),
    "iridescence": ("KHR_materials_iridescence", "iridescenceFactor", 1),
    "iridescence_ior": ("KHR_materials_iridescence", "iridescenceIor", 1),
    "iridescence_minimum": ("KHR_materials_iridescence", "iridescenceThicknessMinimum", 1),
    "iridescence_maximum": ("KHR_materials_iridescence", "iridescenceThicknessMaximum", 1),
    "conductor_ior": ("CANDELA_materials_conductor", "ior", 3),
    "conductor_extinction": ("CANDELA_materials_conductor", "extinction", 3),
}
_NAMES = (*_ENTRIES, "emission", "alpha", "alpha_cutoff", "double_sided", "unlit")


def _numbers(what, value, count):
    """One number, or a list of numbers. The loader of glTF checks their ranges."""
    try:
        numbers = [float(value)] if count == 1 else [float(number) for number in value]
    except (TypeError, ValueError):
        numbers = []
    if len(numbers) != count or not all(math.isfinite(number) for number in numbers):
        expected = "a finite number" if count == 1 else f"{count} finite numbers"
        raise UsageError(f"{what}: expected {expected}, got {value!r}")
    return numbers[0] if count == 1 else numbers


def _boolean(what, value):
    if not isinstance(value, (bool, int, numpy.bool_)) or value not in (True, False):
        raise UsageError(f"{what}: expected True or False, got {value!r}")
    return bool(value)


def _set_emission(what, material, value):
    """Factors are at most 1; a power of two as strength keeps every bit."""
    emission = _numbers(what, value, 3)
    if min(emission) < 0:
        raise UsageError(f"{what}: expected numbers from 0, got {value!r}")
    strength = 2.0 ** max(0, math.frexp(max(emission))[1])
    material["emissiveFactor"] = [number / strength for number in emission]
    material.setdefault("extensions", {})["KHR_materials_emissive_strength"] = {"emissiveStrength": strength}


def _set_alpha(what, material, given):
    factor = _numbers(f"{what}: alpha", given["alpha"], 1)
    colour = material.setdefault(_CORE, {}).setdefault("baseColorFactor", [1, 1, 1, 1])
    colour[3] = factor
    material["alphaMode"] = "MASK" if "alpha_cutoff" in given else "BLEND"
    if "alpha_cutoff" in given:
        material["alphaCutoff"] = _numbers(f"{what}: alpha_cutoff", given["alpha_cutoff"], 1)


def material_of(index, given):
    """The material of glTF with the entries of a dict."""
    what = f"materials[{index}]"
    if not isinstance(given, Mapping):
        raise UsageError(f"{what}: expected a dict, got {given!r}")
    material = {}
    for name, value in given.items():
        if name not in _NAMES:
            raise UsageError(f"{what}: unknown entry {name!r}; the entries are {', '.join(_NAMES)}")
        if name not in _ENTRIES:
            continue
        owner, key, count = _ENTRIES[name]
        place = material.setdefault(_CORE, {}) if owner == _CORE else (
            material.setdefault("extensions", {}).setdefault(owner, {}))
        place[key] = _numbers(f"{what}: {name}", value, count)
    if "base_colour" in given:
        material[_CORE]["baseColorFactor"].append(1.0)
    if "emission" in given:
        _set_emission(f"{what}: emission", material, given["emission"])
    if "alpha" in given:
        _set_alpha(what, material, given)
    elif "alpha_cutoff" in given:
        raise UsageError(f"{what}: alpha_cutoff has no effect without alpha")
    if "double_sided" in given:
        material["doubleSided"] = _boolean(f"{what}: double_sided", given["double_sided"])
    if _boolean(f"{what}: unlit", given.get("unlit", False)):
        material.setdefault("extensions", {})["KHR_materials_unlit"] = {}
    return material
