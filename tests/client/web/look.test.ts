import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Bench, type Visit } from "./harness";
import { guides } from "./sample";

const bench = new Bench();
before(() => bench.start());
after(() => bench.stop());

const kSizes = [
  { width: 1440, height: 900 },
  { width: 1024, height: 700 },
  { width: 768, height: 1024 },
];
const kSections = ["Keep edges", "Equaliser", "Palette", "Colours", "Light", "Camera"];

/** Returns the names of parts that are wider than their place. */
const tooWide = (visit: Visit) =>
  visit.page.evaluate(() =>
    [...document.querySelectorAll("#page, .column, .no-session, section, .row, .row button, .thirds button, .strengths button")]
      .filter((one) => one.scrollWidth > one.clientWidth + 1)
      .map((one) => one.className || one.getAttribute("aria-label") || one.id || one.textContent),
  );

/** Leaves a picture of each part of the columns. */
async function lookAtColumns(visit: Visit, name: string): Promise<void> {
  await visit.screenshot(name);
  for (const section of kSections) await visit.section(section);
  for (let part = 1; part <= 3; ++part) {
    await visit.page.evaluate(() => {
      for (const column of document.querySelectorAll(".column")) column.scrollTop += 600;
    });
    await visit.screenshot(`${name}-${part}`);
  }
}

for (const colorScheme of ["dark", "light"] as const)
  for (const viewport of kSizes)
    test(`EverythingFits${viewport.width}x${viewport.height}In${colorScheme}`, () =>
      bench.visit(
        async (visit) => {
          const name = `${colorScheme}-${viewport.width}`;
          assert.deepEqual(await tooWide(visit), []);
          await visit.screenshot(name + "-start");
          await visit.openSession();
          const pictures = [0.33, 0.67, 1].map((strength) => ({ strength, word: "most", number: 0 }));
          await visit.change({
            preset: { name: "Sharpen all", strength: 1, word: "all", hasTrial: true },
            strengths: { preset: "Sharpen all", trial: "trying strength 0.33", pictures },
          });
          await visit.page.getByRole("group", { name: "Pictures of strengths" }).waitFor();
          await visit.order({ post: { kind: "guides", ...guides } });
          await lookAtColumns(visit, name);
          assert.deepEqual(await tooWide(visit), []);
        },
        { colorScheme, viewport },
      ));

// Luminance and contrast as WCAG 2 defines them.
function luminance(colour: string): number {
  const parts = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255);
  const [r, g, b] = parts.map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
}

function contrast(one: string, other: string): number {
  const [dark, bright] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (bright! + 0.05) / (dark! + 0.05);
}

const kPairs = ["text", "faint", "good", "busy", "bad", "accent"].flatMap((text) =>
  ["panel", "popup"].map((ground) => [text, ground, 4.5] as const),
);
const kMorePairs = [
  ["text", "button", 4.5],
  ["text", "button-hover", 4.5],
  ["text", "frame", 4.5],
  ["text", "header", 4.5],
  ["text", "pressed", 4.5],
  ["on-strong", "strong", 4.5],
  ["faint", "frame", 4.5],
  ["edge", "panel", 3],
] as const;

for (const theme of ["dark", "light"])
  test(`TextHasContrastIn${theme}`, () =>
    bench.visit(async (visit) => {
      const pairs = [...kPairs, ...kMorePairs];
      const names = [...new Set(pairs.flatMap(([text, ground]) => [text, ground]))];
      const colours = await visit.page.evaluate(
        ({ theme, names }) => {
          document.documentElement.dataset.theme = theme;
          const style = getComputedStyle(document.documentElement);
          return Object.fromEntries(names.map((name) => [name, style.getPropertyValue("--" + name).trim()]));
        },
        { theme, names },
      );
      for (const [text, ground, least] of pairs) {
        const found = contrast(colours[text]!, colours[ground]!);
        assert.ok(found >= least, `${text} on ${ground}: ${found.toFixed(2)} is below ${least}`);
      }
    }));
