// How the surface is shown, and from where.

import { command } from "./commands";
import { useLink } from "./context";
import { Button, Check, Choice, Row, Title } from "./controls";
import type { PanelProps } from "./filter_panel";
import { Slider, linear, logarithmic } from "./slider";
import type { ColourBy, UpAxis } from "./snapshot";
import { fixed, short } from "./words";

const kColours: (readonly [ColourBy, string])[] = [
  ["clay", "Clay"],
  ["beta", "Gradient scale β"],
  ["curvature", "Curvature"],
  ["displacement", "Displacement"],
  ["scan", "Colours of the scan"],
];

export function ViewPanel({ document }: PanelProps) {
  const link = useLink();
  const view = document.view;
  return (
    <>
      <Choice
        name="Colour"
        value={view.colour}
        choices={kColours.filter(([by]) => by !== "scan" || document.hasColours)}
        onChange={(by) => link.send(command.colour(by))}
      />
      {view.colour === "displacement" && (
        <>
          <Title text="Displacement" note="full colour at this many cells" />
          <Slider
            name="Displacement"
            value={view.displacementRange}
            scale={logarithmic(0.05, 20)}
            format={short}
            onMove={(cells) => link.send(command.displacementRange(cells))}
            onDone={(cells) => link.send(command.displacementRange(cells))}
          />
        </>
      )}
      <Toggles document={document} />
      <Bookmarks document={document} />
      <Check
        label="Left button turns the view"
        on={document.tool === "look"}
        onChange={(on) => link.send(command.tool(on ? "look" : "paint"))}
      />
      <div class="faint">{view.status}</div>
      <div class="faint">{`depth ${document.depth}`}</div>
    </>
  );
}

function Toggles({ document }: PanelProps) {
  const link = useLink();
  const view = document.view;
  return (
    <>
      <Row>
        <Check
          label="Flat"
          hint="Gives each triangle one shade."
          on={view.flat}
          onChange={(on) => link.send(command.flat(on))}
        />
        <Check
          label="Wireframe"
          on={view.wireframe}
          onChange={(on) => link.send(command.wireframe(on))}
        />
      </Row>
      <Row>
        <Check
          label="Split"
          hint="Shows the original on the left, the edited surface on the right. Hold Space to see the original everywhere."
          on={view.split}
          onChange={(on) => link.send(command.split(on))}
        />
        <Check
          label="Original"
          hint="Shows the surface before all edits."
          on={view.original}
          onChange={(on) => link.send(command.original(on))}
        />
      </Row>
      {view.split && (
        <Slider
          name="Place of the split"
          value={view.splitAt}
          scale={linear(0.05, 0.95)}
          format={fixed(2)}
          onMove={(at) => link.send(command.splitAt(at))}
          onDone={(at) => link.send(command.splitAt(at))}
        />
      )}
    </>
  );
}

function Bookmarks({ document }: PanelProps) {
  const link = useLink();
  const numbers = Array.from({ length: document.view.bookmarks }, (_, i) => i + 1);
  return (
    <>
      <Row>
        <Button label="Frame all" onClick={() => link.send(command.frame())} />
        <Button label="Bookmark" onClick={() => link.send(command.bookmarkAdd())} />
      </Row>
      {numbers.length > 0 && (
        <div class="bookmarks">
          {numbers.map((one) => (
            <Button
              key={one}
              label={String(one)}
              name={`Bookmark ${one}`}
              onClick={() => link.send(command.bookmarkShow(one))}
            />
          ))}
        </div>
      )}
    </>
  );
}

const kUps: UpAxis[] = ["x", "y", "z", "-x", "-y", "-z"];
export const kViews = ["Front", "Back", "Right", "Left", "Top", "Bottom"];

export function CameraPanel({ document }: PanelProps) {
  const link = useLink();
  return (
    <>
      <Choice
        name="Up"
        labelled
        hint="The scan's axis that points up. It is kept with the session."
        value={document.view.up}
        choices={kUps.map((up) => [up, up] as const)}
        onChange={(up) => link.send(command.up(up))}
      />
      <div class="thirds">
        {kViews.map((view) => (
          <Button key={view} label={view} onClick={() => link.send(command.view(view.toLowerCase()))} />
        ))}
      </div>
      <Check
        label="Orthographic"
        hint="Draws without perspective: equal lengths are equal in the picture."
        on={document.view.orthographic}
        onChange={(on) => link.send(command.orthographic(on))}
      />
    </>
  );
}
