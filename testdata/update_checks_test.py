# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Tests update_checks.py on tests and a compiler of its own.   usage: update_checks_test.py FILECHECK"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent

# Prints every line with a `!` as an error, and then the file's line count.
COMPILER = """#!/bin/sh
grep -n '!' "$1" | grep -v -e RUN -e CHECK | while IFS=: read -r line text; do
  printf '%s:%s:3: error: bad [[0]] {{x}}\\n%5s | %s\\n      |   ^\\n' "$1" "$line" "$line" "$text"
done
printf 'last\\n\\n  done\\n'
"""


class UpdateChecks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.clipc = self.folder / "clipc"
        self.clipc.write_text(COMPILER)
        self.clipc.chmod(0o755)

    def update(self, text, name="a.hlsl"):
        test = self.folder / name
        test.write_text(text)
        subprocess.run(
            [sys.executable, HERE / "update_checks.py", "--clipc", self.clipc, test],
            check=True,
            stdout=subprocess.PIPE,
        )
        return test

    def file_check(self, test):
        output = subprocess.run([self.clipc, test], check=True, stdout=subprocess.PIPE).stdout
        return subprocess.run(
            [FILECHECK, test], input=output, check=False, capture_output=True
        ).returncode

    def test_messages_stand_above_their_lines(self):
        test = self.update("// RUN: %clipc %s | FileCheck %s\nx\ny !\nz\nw !\n// CHECK: stale\n")
        self.assertEqual(0, self.file_check(test), test.read_text())
        lines = test.read_text().splitlines()
        self.assertEqual(
            "// CHECK: a.hlsl:[[#@LINE+3]]:3: error: bad {{\\[\\[}}0]] {{\\{\\{}}x}}", lines[3]
        )
        self.assertEqual("y !", lines[6])
        self.assertNotIn("stale", test.read_text())

    def test_a_second_update_changes_nothing(self):
        test = self.update("// RUN: %clipc %s | FileCheck %s\ny !\n")
        first = test.read_text()
        self.assertEqual(first, self.update(first).read_text())

    def test_the_rest_stands_at_the_end(self):
        test = self.update("// RUN: %clipc %s | FileCheck %s\nx\n")
        self.assertEqual(0, self.file_check(test))
        self.assertTrue(
            test.read_text().endswith(
                "x\n\n// CHECK: last\n// CHECK-EMPTY:\n// CHECK-NEXT:   done\n"
            ),
            test.read_text(),
        )

    def test_a_changed_output_is_noticed(self):
        test = self.update("// RUN: %clipc %s | FileCheck %s\nx !\n")
        self.clipc.write_text(COMPILER.replace("bad", "good"))
        self.assertNotEqual(0, self.file_check(test))

    def test_the_parts_of_a_split_file_stay_as_they_are(self):
        test = self.update("// RUN: %clipc %s | FileCheck %s\n\n//--- a.hlsl\nx\n", "split.test")
        self.assertTrue(
            test.read_text().endswith("// CHECK-NEXT:   done\n\n//--- a.hlsl\nx\n"),
            test.read_text(),
        )

    def test_a_failing_run_line_leaves_the_test_alone(self):
        test = self.folder / "b.hlsl"
        test.write_text("// RUN: false\n")
        result = subprocess.run(
            [sys.executable, HERE / "update_checks.py", "--clipc", self.clipc, test],
            check=False,
            capture_output=True,
        )
        self.assertEqual(1, result.returncode)
        self.assertEqual("// RUN: false\n", test.read_text())


if __name__ == "__main__":
    FILECHECK = sys.argv.pop(1)
    unittest.main()
