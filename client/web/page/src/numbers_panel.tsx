// Lengths in the scan's unit: how far the surface moved, and distances.

import { command } from "./commands";
import { useLink } from "./context";
import { Button, Check, Figures, Row } from "./controls";
import type { PanelProps } from "./filter_panel";
import type { Numbers } from "./snapshot";
import { TypedField } from "./typed_field";

const kStale = "Of the surface before the last edit. Measured again when the surface has settled.";

export function NumbersPanel({ document }: PanelProps) {
  const numbers = document.numbers;
  return (
    <>
      <Unit key={document.sessionId} document={document} />
      {numbers.deviation.length > 0 ? (
        <div class={numbers.current ? undefined : "stale"} title={numbers.current ? undefined : kStale}>
          <Figures figures={numbers.deviation} />
        </div>
      ) : (
        <div class="faint">measured when the surface has settled</div>
      )}
      <Histogram numbers={numbers} />
      <Ruler document={document} />
    </>
  );
}

function Unit({ document }: PanelProps) {
  const link = useLink();
  return (
    <div class="labelled">
      <span aria-hidden="true">unit</span>
      <TypedField
        name="Unit"
        placeholder="mm, m, …"
        title="Names the unit of the scan's coordinates, for everybody who opens the scan."
        shown={document.unit}
        onTake={(unit) => link.send(command.unit(unit))}
      />
    </div>
  );
}

// Roots of the areas, so that a small part is seen beside the part that stays.
function Histogram({ numbers }: { numbers: Numbers }) {
  const heights = numbers.histogram.map(Math.sqrt);
  const tallest = Math.max(0, ...heights);
  if (tallest === 0) return null;
  const bars = heights.map((height, i) => `M${i} 1V${(1 - height / tallest).toFixed(3)}H${i + 0.9}V1Z`);
  return (
    <>
      <svg
        class="deviation"
        viewBox={`0 0 ${heights.length} 1`}
        preserveAspectRatio="none"
        role="img"
        aria-label="The surface's area by its move along the normal: inwards left, outwards right"
      >
        <path d={bars.join("")} />
      </svg>
      <div class="ends faint">
        <span>{`-${numbers.range}`}</span>
        <span>{numbers.range}</span>
      </div>
    </>
  );
}

function Ruler({ document }: PanelProps) {
  const link = useLink();
  const { rulerPoints, ruler } = document.numbers;
  const measures = document.tool === "measure";
  return (
    <>
      <Check
        label="Measure"
        hint="Click two points of the surface. The panel shows their distance (M)."
        on={measures}
        onChange={(on) => link.send(command.tool(on ? "measure" : "paint"))}
      />
      {measures && rulerPoints < 2 && (
        <div class="faint">{rulerPoints === 0 ? "first point" : "second point"}</div>
      )}
      {ruler.length > 0 && (
        <>
          <Figures figures={ruler} />
          <Row>
            <Button
              label="Section"
              hint="Cuts the surface along the ruler, in the direction of the view."
              onClick={() => link.send(command.section("cut"))}
            />
            <Button label="Clear" name="Clear the ruler" onClick={() => link.send(command.rulerClear())} />
          </Row>
        </>
      )}
    </>
  );
}
