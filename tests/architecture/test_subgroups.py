#!/usr/bin/env python3
"""No module reads values of other invocations of its subgroup: rule 3 of docs/extending.md.

    test_subgroups.py MODULE.spv...

The instructions that read such values need capabilities, which a module declares in its first instructions.
"""
import struct
import sys
import unittest
from pathlib import Path

MODULES = sys.argv[1:]
del sys.argv[1:]

# SPIR-V specification, section 3.31, with the capabilities of SPV_KHR_shader_ballot, SPV_KHR_subgroup_vote, SPV_KHR_subgroup_rotate and
# SPV_NV_shader_subgroup_partitioned. GroupNonUniform (61) alone permits gl_SubgroupSize and subgroupElect(), which read no such values.
CAPABILITIES = {18: "Groups", 62: "GroupNonUniformVote", 63: "GroupNonUniformArithmetic", 64: "GroupNonUniformBallot",
                65: "GroupNonUniformShuffle", 66: "GroupNonUniformShuffleRelative", 67: "GroupNonUniformClustered", 68: "GroupNonUniformQuad",
                4423: "SubgroupBallotKHR", 4431: "SubgroupVoteKHR", 5297: "GroupNonUniformPartitionedNV", 6026: "GroupNonUniformRotateKHR"}
MAGIC, HEADER_WORDS, OP_CAPABILITY = 0x07230203, 5, 17


def capabilities(words):
    """Returns the capabilities that a module declares."""
    if words[0] != MAGIC:
        raise ValueError("no SPIR-V module")
    found, at = [], HEADER_WORDS
    while words[at] & 0xffff == OP_CAPABILITY:
        found.append(words[at + 1])
        at += words[at] >> 16
    return found


def violations(words):
    return [f"it declares {CAPABILITIES[one]} and may read values of other invocations of its subgroup: docs/extending.md, rule 3"
            for one in capabilities(words) if one in CAPABILITIES]


def words_of(file):
    content = Path(file).read_bytes()
    return struct.unpack(f"<{len(content) // 4}I", content)


class Subgroups(unittest.TestCase):
    def test_capabilities_are_found(self):
        def declared(*all_of_them):
            return [MAGIC, 0x10500, 0, 1, 0, *(word for one in all_of_them for word in (2 << 16 | OP_CAPABILITY, one)), 3 << 16 | 14, 0, 1]
        self.assertEqual(violations(declared(1, 61)), [])
        self.assertEqual(len(violations(declared(1, 61, 65))), 1)
        self.assertIn("rule 3", violations(declared(62, 1))[0])

    def test_no_module_reads_values_of_its_subgroup(self):
        self.assertIn("path.spv", [Path(file).name for file in MODULES])
        for file in MODULES:
            with self.subTest(file):
                self.assertEqual(violations(words_of(file)), [])


unittest.main()
