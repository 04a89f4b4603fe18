"""has_command.py COMMAND [ARGUMENT...]: runs the command; exit status 77 says that there is none."""
import shutil
import subprocess
import sys

command = sys.argv[1:]
if not command or not shutil.which(command[0]):
    print("not found:", command[0] if command and command[0] else "no command given")
    sys.exit(77)
sys.exit(subprocess.run(command).returncode)
