# SPDX-License-Identifier: Apache-2.0
"""The library exports the functions that its header declares, and no others.

python3 exports_test.py <liblitfog_c.so> <litfog.h> <nm>
"""

import pathlib
import re
import subprocess
import sys

library, header, nm = sys.argv[1:]
symbols = subprocess.run([nm, "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
exported = {line.split()[2].split("@")[0] for line in symbols.splitlines() if line.split()[1] != "A"}
declared = set(re.findall(r"^LITFOG_API [^(]*?(litfog_\w+)\(", pathlib.Path(header).read_text("utf-8"), re.MULTILINE))
assert declared and exported == declared, f"exported or declared alone: {sorted(exported ^ declared)}"
