# SPDX-License-Identifier: Apache-2.0
"""GLSL and JSON in pages: glslangValidator compiles each shader against the sources' headers, and the commands read each
light and light spec.

blocks_test.py <glslangValidator> <include folder> <litfog-solve> <litfog-fit> <page>...
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

glslang, include, solve, fit, *pages = sys.argv[1:]
count = {"glsl": 0, "json": 0}


def run(page, block, *command):
    ended = subprocess.run(command, capture_output=True, text=True)
    assert ended.returncode == 0, f"{page}: {command}\n{ended.stdout}{ended.stderr}\n{block}"


with tempfile.TemporaryDirectory() as folder:
    for page in pages:
        text = pathlib.Path(page).read_text(encoding="utf-8")
        for language, block in re.findall(r"^```(glsl|json)\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
            count[language] += 1
            if language == "glsl":
                is_whole = block.startswith("#version")
                shader = pathlib.Path(folder, "block.frag")
                head = "#version 330 core\n#extension GL_GOOGLE_include_directive : require\n"
                shader.write_text(block if is_whole else f"{head}{block}\nvoid main() {{}}\n")
                run(page, block, glslang, *(["-V", "-o", f"{folder}/block.spv"] if is_whole else ["-l"]), f"-I{include}", shader)
            else:
                file = pathlib.Path(folder, "block.json")
                file.write_text(block, encoding="utf-8")
                content = json.loads(block)
                if isinstance(content, list):  # layers of fog, which a test of litfog-demo reads
                    continue
                kind = content["litfog"]
                run(page, block, *{"light": [solve, "--visibility", "100", "--light", file], "light-spec": [fit, file]}[kind])
assert min(count.values()) > 0, f"too few blocks in these pages: {count}"
