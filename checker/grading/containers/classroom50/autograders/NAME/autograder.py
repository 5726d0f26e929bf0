"""Judges a submission with the Rigid Body Workbook; the runner of Classroom 50 starts this in the student's checkout."""

import os
import subprocess
import sys
from pathlib import Path

workbook = Path(os.environ.get("WORKBOOK", "/workbook"))
grade = workbook / "checker/grading/containers/grade.sh"
sys.exit(subprocess.call([str(grade), "classroom50", ".", str(Path(__file__).parent / "cases"), "result.json"]))
