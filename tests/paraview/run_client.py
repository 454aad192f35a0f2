"""Runs a script in ParaView's client: run_client.py SCRIPT PLUGIN GUI_DRIVER FOLDER -- COMMAND...

COMMAND starts the client. SCRIPT finds the plugin, the library of GuiDriver.cxx, the folder for
pictures and the plugin's states in the environment. It ends the client and prints "all well" on
success. A client that crashes on exit fails the test.
"""
import os
import shutil
import subprocess
import sys
import tempfile

script, plugin, gui, folder = (os.path.abspath(name) for name in sys.argv[1:5])
command = sys.argv[sys.argv.index("--") + 1:]
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
with tempfile.TemporaryDirectory() as home:
    # Default settings, and no welcome dialog.
    environment = dict(os.environ, PYTHONPATH=os.path.dirname(script), PYTHONDONTWRITEBYTECODE="1",
                       HOME=home, XDG_CONFIG_HOME=home, XDG_RUNTIME_DIR=home,
                       DASHBOARD_TEST_FROM_CTEST="1", PLUGIN=plugin, GUI_DRIVER=gui, FOLDER=folder,
                       STATES=os.path.join(os.path.dirname(script), "..", "..", "paraview-plugin", "states"))
    done = subprocess.run([*command, "--dr", "--script=" + script], env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
print(done.stdout)
if done.returncode != 0 or "all well" not in done.stdout.splitlines():
    sys.exit("the client ended with %d" % done.returncode)
