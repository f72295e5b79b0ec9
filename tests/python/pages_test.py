# SPDX-License-Identifier: Apache-2.0
"""Python in pages: each block runs, from the sources' folder, and a comment in it begins with each line that it prints.

pages_test.py <page>...
"""

import contextlib
import io
import re
import sys

count = 0
for page in sys.argv[1:]:
    with open(page, encoding="utf-8") as file:
        blocks = re.findall(r"^```python\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
    for block in blocks:
        count += 1
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            exec(block, {})
        lines = output.getvalue().splitlines()
        assert lines, f"{page} prints nothing:\n{block}"
        for line in lines:
            assert f"# {line}" in block, f"{page} prints {line!r}, and no comment says so:\n{block}"
assert count > 0, "there is no Python in these pages"
