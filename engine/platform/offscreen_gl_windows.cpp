// A window that is never shown provides the context; Windows has no context without a window.
#include <epoxy/gl.h>
#include <epoxy/wgl.h>
#include <windows.h>

#include <system_error>

#include "engine/language/catalogue.h"
#include "engine/platform/offscreen_gl.h"

// libepoxy stores its functions per thread, and allocates them when the system notifies a DLL of a new thread
// (cmake/windows.cmake gives its DllMain this name). In a program of one file the system notifies this function.
extern "C" BOOL WINAPI epoxy_on_thread(HINSTANCE, DWORD, LPVOID);
extern "C" {
using OnThread = BOOL(WINAPI*)(HINSTANCE, DWORD, LPVOID);
extern const OnThread epoxy_thread_callback;
__attribute__((section(".CRT$XLF"), used)) const OnThread epoxy_thread_callback = &epoxy_on_thread;
}

namespace moltact {
namespace {

Problem noContext(const std::string& what) {
  return {.file = {},
          .message = trf("no off-screen OpenGL: {0}", what),
          .remedy = tr("install the graphics card's own driver (OpenGL 3.3)")};
}

std::string lastError() { return std::system_category().message(int(GetLastError())); }

HWND hiddenWindow() {
  static const ATOM kind = [] {
    WNDCLASSW wanted{};
    wanted.style = CS_OWNDC;
    wanted.lpfnWndProc = DefWindowProcW;
    wanted.hInstance = GetModuleHandleW(nullptr);
    wanted.lpszClassName = L"moltact_offscreen";
    return RegisterClassW(&wanted);
  }();
  return CreateWindowW(MAKEINTATOM(kind), L"", WS_OVERLAPPED, 0, 0, 16, 16, nullptr, nullptr, GetModuleHandleW(nullptr),
                       nullptr);
}

}  // namespace

// display_ is the window's device context, surface_ the window.
Expected<std::unique_ptr<OffscreenGl>> OffscreenGl::create() {
  std::unique_ptr<OffscreenGl> gl(new OffscreenGl);
  HWND const window = hiddenWindow();
  gl->surface_ = window;
  if (!window) return noContext(lastError());
  HDC const dc = GetDC(window);
  gl->display_ = dc;
  PIXELFORMATDESCRIPTOR wanted{};
  wanted.nSize = sizeof wanted;
  wanted.nVersion = 1;
  wanted.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER;
  wanted.iPixelType = PFD_TYPE_RGBA;
  wanted.cColorBits = 32;
  const int format = ChoosePixelFormat(dc, &wanted);
  if (!format || !SetPixelFormat(dc, format, &wanted)) return noContext(lastError());
  // A first context provides the function that creates the required one.
  HGLRC const first = wglCreateContext(dc);
  if (!first || !wglMakeCurrent(dc, first)) return noContext(lastError());
  const auto create = reinterpret_cast<PFNWGLCREATECONTEXTATTRIBSARBPROC>(
      reinterpret_cast<void*>(wglGetProcAddress("wglCreateContextAttribsARB")));
  const int attributes[] = {
      WGL_CONTEXT_MAJOR_VERSION_ARB,    3, WGL_CONTEXT_MINOR_VERSION_ARB, 3, WGL_CONTEXT_PROFILE_MASK_ARB,
      WGL_CONTEXT_CORE_PROFILE_BIT_ARB, 0};
  gl->context_ = create ? create(dc, nullptr, attributes) : nullptr;
  wglMakeCurrent(nullptr, nullptr);
  wglDeleteContext(first);
  if (!gl->context_) return noContext(trf("OpenGL 3.3 core is not offered ({0})", lastError()));
  if (!gl->makeCurrent()) return noContext(trf("the context cannot be made current ({0})", lastError()));
  return {std::move(gl)};
}

bool OffscreenGl::makeCurrent() {
  const bool made = wglMakeCurrent(static_cast<HDC>(display_), static_cast<HGLRC>(context_)) != 0;
  epoxy_handle_external_wglMakeCurrent();
  return made;
}

OffscreenGl::~OffscreenGl() {
  wglMakeCurrent(nullptr, nullptr);
  if (context_) wglDeleteContext(static_cast<HGLRC>(context_));
  HWND const window = static_cast<HWND>(surface_);
  if (display_) ReleaseDC(window, static_cast<HDC>(display_));
  if (window) DestroyWindow(window);
}

}  // namespace moltact
