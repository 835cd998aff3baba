// SPDX-License-Identifier: MIT
#include "render/sheet.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "core/error.h"
#include "mono.h"
#include "roboto.h"

namespace ballpit {

namespace {

// In the order of TextSize: [pixel] at 1080 lines, and by which part of the text scale it grows.
constexpr std::array<float, 5> kSizes{36, 40, 48, 22, 34}, kGrowth{0.42f, 0.75f, 0.42f, 0, 0};
constexpr float kSmallestText = 9;  // [pixel] smaller letters are not legible
constexpr float kLargest = 128;     // [pixel] larger letters are magnified, to save memory
constexpr float kFine = 64;         // [pixel] up to this size, letters are sampled twice horizontally
constexpr float kHead = 4.5f;       // of an arrow [width of its line]
constexpr float kDots = 2.5f;       // from one dot to the next [width]

ImVec2 im(Vec2 v) { return {v.x, v.y}; }

/// Western European languages, and the signs of formulas.
const ImVector<ImWchar>& glyph_ranges() {
  static const ImVector<ImWchar> ranges = [] {
    ImFontGlyphRangesBuilder builder;
    builder.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesDefault());
    builder.AddText(" −–—…·×√≤≥≈∞∂Δ°⁰¹²³⁴⁵⁶⁷⁸⁹⁻µ‘’“”„ αβγδεζλμπρστω");
    ImVector<ImWchar> result;
    builder.BuildRanges(&result);
    return result;
  }();
  return ranges;
}

constexpr ImWchar kMissingSigns[] = {0x2070, 0x207B, 0x2190, 0x2192, 0x230A, 0x230B, 0};  // ⁰ to ⁻, ← to →, ⌊ ⌋

/// Source code, with formulas in its comments.
const ImVector<ImWchar>& code_ranges() {
  static const ImVector<ImWchar> ranges = [] {
    ImFontGlyphRangesBuilder builder;
    builder.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesDefault());
    builder.AddText("⌊⌋·×−…");
    ImVector<ImWchar> result;
    builder.BuildRanges(&result);
    return result;
  }();
  return ranges;
}

/// ImGui does not check its allocations, so the allocator throws.
ImGuiContext* make_context() {
  const auto allocate = [](size_t size, void*) {
    if (void* const memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
  };
  ImGui::SetAllocatorFunctions(allocate, [](void* memory, void*) { std::free(memory); });
  return ImGui::CreateContext();
}

}  // namespace

float line_height(TextSize size, float text_scale) {
  const auto k = static_cast<size_t>(size);
  return kSizes[k] * (1 + kGrowth[k] * (text_scale - 1));
}

Sheet::Sheet() : context_(make_context()) {
  ImGui::SetCurrentContext(context_);
  ImGui::GetIO().IniFilename = nullptr;  // ImGui must not write a file for the state of its windows
  if (!ImGui_ImplOpenGL3_Init("#version 450 core")) {
    ImGui::DestroyContext(context_);
    throw RunError("Dear ImGui", "cannot draw in this OpenGL context");
  }
  list_ = std::make_unique<ImDrawList>(ImGui::GetDrawListSharedData());
}

Sheet::~Sheet() {
  ImGui::SetCurrentContext(context_);
  list_.reset();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

float Sheet::unit() const { return static_cast<float>(height_) / 1080.0f; }

void Sheet::load_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  for (size_t k = 0; k < fonts_.size(); ++k) {
    const auto kind = static_cast<TextSize>(k);
    const bool is_panel = kind == TextSize::panel, is_code = kind == TextSize::code;
    const float min = kSmallestText * (is_panel ? panel_density_ : 1);
    const float height = is_panel ? kSizes[k] * panel_scale_ : line_height(kind, text_scale_);
    const float size = std::max(min, std::round(height * unit())), drawn = std::min(size, kLargest);
    config.OversampleH = drawn <= kFine ? 2 : 1;
    const auto add = [&](const unsigned char* font, size_t bytes, const ImWchar* ranges) {
      return atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(font), static_cast<int>(bytes), drawn, &config,
                                        ranges);
    };
    fonts_[k] =
        is_code ? add(mono(), mono_size(), code_ranges().Data) : add(roboto(), roboto_size(), glyph_ranges().Data);
    if (!is_code) {  // the signs that Roboto lacks
      config.MergeMode = true;
      add(mono(), mono_size(), kMissingSigns);
      config.MergeMode = false;
    }
    fonts_[k]->Scale = size / drawn;
  }
  ImGui::GetIO().FontDefault = font(TextSize::panel);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  if (!ImGui_ImplOpenGL3_CreateFontsTexture()) throw RunError("OpenGL", "no memory for the letters");
  font_height_ = height_;
}

void Sheet::scale_panel(float scale, float density) {
  if (scale == panel_scale_ && density == panel_density_) return;
  panel_scale_ = scale;
  panel_density_ = density;
  ImGui::SetCurrentContext(context_);
  load_fonts();
}

/// Does for draw lists what ImGui::NewFrame() does in a frame of ImGui. Without it, lines have no colour.
void Sheet::prepare_shapes() {
  ImDrawListSharedData& shared = *ImGui::GetDrawListSharedData();
  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  shared.TexUvWhitePixel = atlas.TexUvWhitePixel;
  shared.TexUvLines = atlas.TexUvLines;
  shared.CurveTessellationTol = ImGui::GetStyle().CurveTessellationTol;
  shared.SetCircleTessellationMaxError(ImGui::GetStyle().CircleTessellationMaxError);
}

void Sheet::begin(int width, int height, const PictureRect& part, float scale) {
  ImGui::SetCurrentContext(context_);
  width_ = width;
  height_ = height;
  part_ = part;
  if (!ImGui::GetIO().BackendRendererUserData) throw RunError("Dear ImGui", "the OpenGL backend is gone");
  if (font_height_ == 0) ImGui_ImplOpenGL3_NewFrame();  // makes the backend's objects
  if (font_height_ != height || scale != text_scale_) {
    text_scale_ = scale;
    load_fonts();
  }
  prepare_shapes();
  list_->_ResetForNewFrame();
  list_->Flags = ImDrawListFlags_AntiAliasedLines | ImDrawListFlags_AntiAliasedFill |
                 ImDrawListFlags_AllowVtxOffset;  // for more than 65 536 vertices
  list_->PushClipRect({0, 0}, {static_cast<float>(part.width), static_cast<float>(part.height)});
  list_->PushTextureID(ImGui::GetIO().Fonts->TexID);
}

void Sheet::draw() {
  ImGui::SetCurrentContext(context_);
  ImDrawList* lists[] = {list_.get()};
  ImDrawData data;
  data.Valid = true;
  data.CmdLists = lists;
  data.CmdListsCount = 1;
  data.TotalIdxCount = list_->IdxBuffer.Size;
  data.TotalVtxCount = list_->VtxBuffer.Size;
  data.DisplayPos = {-static_cast<float>(part_.left), -static_cast<float>(part_.top)};
  data.DisplaySize = {static_cast<float>(width_), static_cast<float>(height_)};
  data.FramebufferScale = {1, 1};
  ImGui_ImplOpenGL3_RenderDrawData(&data);
}

Vec2 Sheet::size_of(std::string_view text, TextSize size) const {
  const ImFont* font = this->font(size);
  const ImVec2 extent =
      font->CalcTextSizeA(font->FontSize * font->Scale, INFINITY, 0, text.data(), text.data() + text.size());
  return {extent.x, extent.y};
}

void Sheet::text(Vec2 at, Anchor anchor, Rgba color, std::string_view text, TextSize size, float scale) {
  const Vec2 corner = at - Vec2(anchor.x, anchor.y) * scale * size_of(text, size);
  const ImFont* font = this->font(size);
  list_->AddText(font, scale * font->FontSize * font->Scale, {std::round(corner.x), std::round(corner.y)}, color,
                 text.data(), text.data() + text.size());
}

void Sheet::bordered_text(Vec2 at, Anchor anchor, Rgba color, Rgba border, std::string_view text, TextSize size) {
  const float width = std::max(1.0f, std::round(2.5f * unit()));
  for (const Vec2& way :
       {Vec2(-1, -1), Vec2(0, -1), Vec2(1, -1), Vec2(-1, 0), Vec2(1, 0), Vec2(-1, 1), Vec2(0, 1), Vec2(1, 1)}) {
    this->text(at + width * way, anchor, border, text, size);
  }
  this->text(at, anchor, color, text, size);
}

void Sheet::line(Vec2 a, Vec2 b, Rgba color, float width) {
  list_->AddLine(im(a), im(b), color, std::max(width, 1.0f));
}

void Sheet::dotted(Vec2 a, Vec2 b, Rgba color, float width) {
  const float w = std::max(width, 1.0f), way = length(b - a);
  const int dots = static_cast<int>(way / (kDots * w));
  for (int k = 0; k <= dots; ++k) disc(a + (b - a) * (dots > 0 ? float(k) / float(dots) : 0.0f), 0.5f * w, color);
}

void Sheet::arrow(Vec2 from, Vec2 to, Rgba color, float width) {
  const float way = length(to - from), w = std::max(width, 1.0f);
  if (!(way > 0)) return;
  const Vec2 along = (to - from) / way, across(-along.y, along.x);
  const float head = std::min(kHead * w, way);
  line(from, to - 0.9f * head * along, color, w);
  list_->AddTriangleFilled(im(to), im(to - head * along + 0.5f * head * across),
                           im(to - head * along - 0.5f * head * across), color);
}

void Sheet::curved_arrow(Vec2 from, Vec2 over, Vec2 to, Rgba color, float width) {
  const float w = std::max(width, 1.0f), head = kHead * w;
  const Vec2 neck = to + 0.9f * head * normalize(over - to);
  list_->AddBezierQuadratic(im(from), im(over), im(neck), color, w, 24);
  arrow(to + head * normalize(over - to), to, color, w);
}

void Sheet::triangle(Vec2 a, Vec2 b, Vec2 c, Rgba fill) { list_->AddTriangleFilled(im(a), im(b), im(c), fill); }
void Sheet::box(Vec2 low, Vec2 high, Rgba fill, float rounding) {
  list_->AddRectFilled(im(low), im(high), fill, rounding);
}
void Sheet::frame(Vec2 low, Vec2 high, Rgba color, float width, float rounding) {
  list_->AddRect(im(low), im(high), color, rounding, 0, std::max(width, 1.0f));
}
void Sheet::disc(Vec2 centre, float radius, Rgba fill) { list_->AddCircleFilled(im(centre), radius, fill, 24); }
void Sheet::ring(Vec2 centre, float radius, Rgba color, float width) {
  list_->AddCircle(im(centre), radius, color, 48, std::max(width, 1.0f));
}

}  // namespace ballpit
