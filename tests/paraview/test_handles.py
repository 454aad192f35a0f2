import ctypes, os, sys, traceback
from paraview.simple import *
hands = ctypes.PyDLL(os.environ["HANDS"])
hands.hands_time_of_move.restype = ctypes.c_double
hands.hands_number.restype = ctypes.c_double
hands.hands_type.argtypes = [ctypes.c_int, ctypes.c_int, ctypes.c_double]
FOLDER = os.environ["FOLDER"]
def pic(name):
    hands.hands_wait(300)
    hands.hands_picture(os.path.join(FOLDER, name).encode())
try:
    hands.hands_wait(500)
    LoadPlugin(os.environ["PLUGIN"], remote=False, ns=globals())
    view = GetActiveViewOrCreate("RenderView")
    domain = PlanarDomainSource(registrationName="Domain")
    Show(domain, view)
    s = SingularitySource(registrationName="Singularities")
    h = CrossFieldMap(Input=domain, Singularities=s)
    lines = Separatrices(Input=h)
    Show(lines, view)
    view.ResetCamera()
    Render()
    hands.hands_wait(500)
    SetActiveSource(s)
    hands.hands_wait(500)
    print("rows", hands.hands_rows())
    pic("start.png")
    r = view.GetRenderer()
    def pixel(x, y):
        r.SetWorldPoint(x, y, 0, 1); r.WorldToDisplay()
        p = r.GetDisplayPoint(); return round(p[0]), round(p[1])
    a = pixel(0.424, 0.424); b = pixel(0.2, 0.5)
    print(a, b)
    hands.hands_move(*a, False); hands.hands_wait(50)
    hands.hands_press(*a); hands.hands_wait(50)
    times = []
    for i in range(1, 61):
        x = round(a[0] + (b[0]-a[0])*i/60); y = round(a[1] + (b[1]-a[1])*i/60)
        times.append(hands.hands_time_of_move(x, y))
        if i in (1, 30): print(list(s.Singularities)[:4], hands.hands_number(0, 0))
    pic("dragging.png")
    hands.hands_release(*b); hands.hands_wait(200)
    print(list(s.Singularities)[:4])
    print(sorted(times)[30], times[:5])
    pic("dragged.png")
    print("all well")
except Exception:
    traceback.print_exc()
sys.stdout.flush()
hands.hands_quit()
