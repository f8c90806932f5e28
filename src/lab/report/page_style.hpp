#pragma once
/// Looks and behaviour of the page. Without the script points still tell what they are, by their titles.

#include <string_view>

namespace flipside::lab::report {

inline constexpr std::string_view page_style = R"(
:root { color-scheme: light dark; --paper: #fff; --ink: #1b1f24; --soft: #57606a; --line: #d0d7de; --panel: #f6f8fa;
        --link: #0b5cad; --good: #00694c; --bad: #a33f00; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #14171a; --ink: #e6e9ec; --soft: #a3adb8; --line: #353c44; --panel: #1d2126; --link: #7fbcf5;
          --good: #4fd1a5; --bad: #ff9d5c; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 62rem; padding: 1rem; background: var(--paper); color: var(--ink);
       font: 1rem/1.55 system-ui, sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.25; } h2 { font-size: 1.35rem; margin-top: 3rem; } h3 { font-size: 1.05rem; }
a { color: var(--link); } p { max-width: 46rem; } nav ul { padding-left: 1.2rem; columns: 16rem; }
figure { margin: 1.5rem 0 2.5rem; } figcaption { max-width: 46rem; color: var(--soft); }
.wide { overflow-x: auto; } .wide:focus-visible { outline: 2px solid var(--link); }
svg { display: block; width: 100%; min-width: 44rem; height: auto; }
.point { cursor: help; } .point:hover use { stroke: currentColor; stroke-width: .6; }
table { border-collapse: collapse; font-size: .88rem; } caption { text-align: left; font-weight: 600; padding: .4rem 0; }
th, td { padding: .25rem .7rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th, td { min-width: 7rem; } td.number { min-width: 0; }
thead th { background: var(--panel); } td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 600; }
details { margin-top: .6rem; } summary { cursor: pointer; color: var(--link); }
footer { margin-top: 3rem; border-top: 1px solid var(--line); color: var(--soft); font-size: .9rem; }
footer dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1rem; } footer dd { margin: 0; overflow-wrap: anywhere; }
#tip { position: fixed; z-index: 1; max-width: min(22rem, 90vw); padding: .4rem .6rem; white-space: pre-line; pointer-events: none;
       background: var(--ink); color: var(--paper); border-radius: .3rem; font-size: .85rem; line-height: 1.4; }
@media (max-width: 40rem) { footer dl { grid-template-columns: 1fr; } footer dt { font-weight: 600; } }
)";

inline constexpr std::string_view page_script = R"(
const tip = document.getElementById('tip');
function show(event) {
  const point = event.target.closest && event.target.closest('.point');
  tip.hidden = !point;
  if (!point) return;
  const title = point.querySelector('title');  // ours instead of the browser's, which comes late
  if (title) { point.dataset.says = title.textContent; title.remove(); }
  tip.textContent = point.dataset.says;
  const at = point.getBoundingClientRect(), box = tip.getBoundingClientRect();
  tip.style.left = Math.max(4, Math.min(at.right + 6, innerWidth - box.width - 4)) + 'px';
  tip.style.top = Math.max(4, at.top - box.height - 6) + 'px';
}
document.addEventListener('pointerover', show);
document.addEventListener('pointerdown', show);
document.addEventListener('scroll', () => { tip.hidden = true; }, true);
document.addEventListener('keydown', (event) => { if (event.key === 'Escape') tip.hidden = true; });
)";

}  // namespace flipside::lab::report
