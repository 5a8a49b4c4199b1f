"""pooltool writes its settings below the home folder when it is imported: here one of the tests."""

import os
import pathlib
import sys
import tempfile

os.environ["HOME"] = tempfile.mkdtemp(prefix="pooltool-home-")
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
