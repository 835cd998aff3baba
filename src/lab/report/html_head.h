// SPDX-License-Identifier: MIT
#pragma once

namespace ballpit {

// The size of the text follows the width of the window, from a phone to a projector. Wide tables scroll.
inline constexpr const char* kHtmlHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Ballpit: the laboratory's report</title>
<style>
:root { --ground: #FFFFFF; --text: #1A1A1A; --faint: #DDE1E6; --quiet: #5F6368; --link: #0072B2; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #14171C; --text: #E8EAED; --faint: #343A43; --quiet: #9AA0A6; --link: #56B4E9; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 0 clamp(14px, 3vw, 56px) 4em; max-width: 1840px; background: var(--ground); color: var(--text);
  font: clamp(16px, 0.55vw + 13px, 24px)/1.5 Roboto, "Helvetica Neue", Arial, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.9em; line-height: 1.2; margin: 1em 0 0.3em; }
h2 { font-size: 1.45em; line-height: 1.25; margin: 0 0 0.2em; }
p { max-width: 70ch; margin: 0.5em 0; }
a { color: var(--link); }
section { border-top: 2px solid var(--faint); margin-top: 2.2em; padding-top: 1.4em; }
.quiet { color: var(--quiet); font-size: 0.85em; margin: 0.2em 0; }
.answer { font-weight: 600; font-size: 1.1em; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 660px), 1fr)); gap: 1em 2em; margin: 1em 0; }
figure { margin: 0; }
figure img { display: block; width: 100%; height: auto; max-width: 960px; }
@media (max-width: 700px) {
  .charts { margin: 0.8em -14px; }
  .contents td { display: block; border: 0; padding: 0; }
  .contents td + td { padding-bottom: 0.8em; }
}
.scroll { overflow-x: auto; }
.scroll th, .scroll td { white-space: nowrap; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: 0.8em 0; }
th, td { text-align: left; vertical-align: top; padding: 0.3em 0.9em 0.3em 0; border-bottom: 1px solid var(--faint); }
td.number, th.number { text-align: right; }
code { font-size: 0.9em; overflow-wrap: anywhere; }
</style>
</head>
<body>
)";

}  // namespace ballpit
