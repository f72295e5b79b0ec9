# SPDX-License-Identifier: Apache-2.0
"""Holds the C face to the ABI that this minor version keeps, abi.xml, without abidiff: the exported functions, and the
size and the offsets of each struct, which the C compiler is asked for.

python3 abi_test.py <abi.xml> <liblitfog_c.so> <include folder> <nm> <C compiler>
"""

import re
import subprocess
import sys
import xml.etree.ElementTree

abi_file, library, include, nm, compiler = sys.argv[1:]
abi = xml.etree.ElementTree.parse(abi_file).getroot()

released = {symbol.get("name") for symbol in abi.iter("elf-symbol")}
lines = subprocess.run([nm, "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
exported = {line.split()[2].split("@")[0] for line in lines.splitlines() if line.split()[1] != "A"}
header = open(f"{include}/litfog/c/litfog.h", encoding="utf-8").read()
declared = set(re.findall(r"^LITFOG_API [^(]*?(litfog_\w+)\(", header, re.MULTILINE))
assert released and released <= exported, f"no longer exported: {sorted(released - exported)}"
assert exported == declared, f"exported or declared alone: {sorted(exported ^ declared)}"

checks = []
for struct in abi.iter("class-decl"):
    name = struct.get("name")
    if struct.get("is-declaration-only"):
        continue
    assert name.startswith("litfog_"), name
    checks.append(f"sizeof({name}) == {int(struct.get('size-in-bits')) // 8}")
    for member in struct.iter("data-member"):
        field = member.find("var-decl").get("name")
        checks.append(f"offsetof({name}, {field}) == {int(member.get('layout-offset-in-bits')) // 8}")
assert len(checks) > 100
source = "#include <litfog/c/litfog.h>\n" + "".join(f'_Static_assert({c}, "{c}");\n' for c in checks)
subprocess.run([compiler, "-std=c11", "-fsyntax-only", f"-I{include}", "-xc", "-"], check=True, input=source, text=True)
