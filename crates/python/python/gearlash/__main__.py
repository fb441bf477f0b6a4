"""``python -m gearlash`` is the command ``gearlash``."""

import sys

from gearlash._command import main

sys.exit(main())
