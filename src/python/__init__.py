# SPDX-License-Identifier: Apache-2.0
from litfog._litfog import *
from litfog._litfog import __doc__, __version__
