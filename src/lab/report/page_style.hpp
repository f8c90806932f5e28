#pragma once
/// Looks and behaviour of the page. Without the script keys still work, and points still tell what they are,
/// by their titles.

#include <string_view>

namespace flipside::lab::report {

inline constexpr std::string_view page_style = R"(
:root { color-scheme: light dark; --paper: #fff; --ink: #1b1f24; --soft: #57606a; --line: #d0d7de; --panel: #f6f8fa;
        --link: #0b5cad; --good: #00694c; --bad: #a33f00; --warn: #fff3e0; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #14171a; --ink: #e6e9ec; --soft: #a3adb8; --line: #353c44; --panel: #1d2126; --link: #7fbcf5;
          --good: #4fd1a5; --bad: #ff9d5c; --warn: #3a2a14; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 78rem; padding: 1rem; background: var(--paper); color: var(--ink);
       font: 1rem/1.5 system-ui, sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 1.6rem; line-height: 1.2; margin: .3rem 0; } h2 { font-size: 1.3rem; margin: 2.5rem 0 .5rem; }
h3 { font-size: 1.05rem; margin: .3rem 0; }
a { color: var(--link); } p { max-width: 52rem; margin: .5rem 0; } nav ul { padding-left: 1.2rem; columns: 16rem; }
.reading, figcaption { color: var(--soft); font-size: .92rem; }
.warning { background: var(--warn); border-left: 4px solid var(--bad); padding: .5rem .8rem; max-width: none; }
#picks h2 { margin-top: 1rem; } #findings li { max-width: 62rem; margin: .3rem 0; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 27rem), 1fr)); gap: 1rem 2.5rem; }
figure { margin: 1rem 0; min-width: 0; }
figure > svg { display: block; width: 100%; max-width: 40rem; height: auto; }
.axis { margin: 0; color: var(--soft); font-size: .88rem; } .across { text-align: right; max-width: 40rem; }
.key { display: flex; flex-wrap: wrap; gap: .1rem 1rem; margin: .5rem 0; font-size: .9rem; }
.key label { display: inline-flex; align-items: center; gap: .35rem; cursor: pointer; padding: .15rem 0; }
.key label:has(:not(:checked)) { color: var(--soft); } .key input { margin: 0; }
.swatch { width: 2.25rem; height: .75rem; flex: none; }
.wide { overflow-x: auto; } .wide:focus-visible { outline: 2px solid var(--link); }
.point { cursor: help; } .point:hover use { stroke: currentColor; stroke-width: .6; }
table { border-collapse: collapse; font-size: .88rem; } caption { text-align: left; font-weight: 600; padding: .4rem 0; }
th, td { padding: .25rem .7rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
.wide th, .wide td { min-width: 7rem; overflow-wrap: normal; } .wide td.number { min-width: 0; }
thead th { background: var(--panel); } td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.picks { width: 100%; font-size: .95rem; } .picks th, .picks td { overflow-wrap: normal; }
@media (min-width: 62rem) { .picks .take { min-width: 16rem; } .picks tbody th { min-width: 11rem; } }
.take { font-weight: 600; border-left: 5px solid var(--of); }
.scenes { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 14rem), 1fr)); gap: 1rem 2rem; }
.scene g { fill: none; stroke: currentColor; stroke-width: 1.3px; }
.scene path, .scene circle { vector-effect: non-scaling-stroke; } .scene .part { fill: var(--line); }
.scene .ball { fill: var(--soft); stroke: none; }
.scene svg { display: block; width: 100%; height: 15rem; } .scene p { font-size: .9rem; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 600; }
details { margin-top: .6rem; } summary { cursor: pointer; color: var(--link); }
footer { margin-top: 3rem; border-top: 1px solid var(--line); color: var(--soft); font-size: .9rem; }
footer dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1rem; } footer dd { margin: 0; }
#tip { position: fixed; z-index: 1; max-width: min(22rem, 90vw); padding: .4rem .6rem; white-space: pre-line; pointer-events: none;
       background: var(--ink); color: var(--paper); border-radius: .3rem; font-size: .85rem; line-height: 1.4; }
@media (max-width: 44rem) {
  footer dl { grid-template-columns: 1fr; } footer dt { font-weight: 600; }
  h1 { font-size: 1.3rem; } .picks thead { display: none; } .picks, .picks tbody { display: block; }
  .picks tr { display: block; padding: .5rem 0; border-bottom: 1px solid var(--line); }
  .picks th, .picks td { display: block; border-bottom: 0; padding: .05rem 0; } .picks .take { padding-left: .5rem; }
  .picks td[data-column]::before { content: attr(data-column) ": "; color: var(--soft); }
}
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
