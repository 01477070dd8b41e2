// The bounds on what edits do, and the region in which nothing moves.

import { command } from "./commands";
import { useLink } from "./context";
import { Button, Check, Row, Title, useOver } from "./controls";
import { isViewer, type PanelProps } from "./filter_panel";
import { Slider, logarithmic } from "./slider";
import type { Lasso } from "./snapshot";
import { short } from "./words";

export function LimitsPanel({ document }: PanelProps) {
  useOver("protection");
  const disabled = isViewer(document);
  return (
    <>
      <ControlChecks document={document} />
      {document.rims && (
        <div class="faint" title="The others are small holes, or run over another piece">
          {document.rims}
        </div>
      )}
      {document.walls && <div class="faint">{document.walls}</div>}
      <LargestMove document={document} />
      <LassoButtons document={document} />
      <RegionButtons document={document} />
      <div class="faint" role="status">
        {document.lasso !== "off" && !disabled
          ? "drag a line in the picture; by keys: Tab leads to a pen there"
          : "the protected region is hatched"}
      </div>
    </>
  );
}

function ControlChecks({ document }: PanelProps) {
  const link = useLink();
  const { pinRims, cap, keepVolume } = document.controls;
  const disabled = isViewer(document);
  return (
    <Row>
      <Check
        label="Rims stay"
        on={pinRims}
        disabled={disabled || document.closed}
        hint="The rims of an open scan stay where they are. A closed scan has none."
        onChange={(on) => link.send(command.controls(on, cap, keepVolume))}
      />
      <Check
        label="Volume stays"
        on={keepVolume}
        disabled={disabled || !document.closed || document.keepsEdges}
        hint="A closed scan keeps its volume. An open scan has none. Not while edges are kept."
        onChange={(on) => link.send(command.controls(pinRims, cap, on))}
      />
    </Row>
  );
}

function LargestMove({ document }: PanelProps) {
  const link = useLink();
  const any = document.diagonal;
  const { pinRims, cap, keepVolume } = document.controls;
  const line = (move: number) => command.controls(pinRims, move < any ? move : 0, keepVolume);
  return (
    <>
      <Title
        text="Largest move"
        note="at the right: any"
        hint="In the scan's units. No point of the surface moves farther."
      />
      <Slider
        name="Largest move"
        value={cap > 0 ? Math.min(cap, any) : any}
        scale={logarithmic(1e-6 * any, any)}
        format={short}
        disabled={isViewer(document)}
        onMove={(move) => link.send(command.preview(line(move)))}
        onDone={(move) => link.send(line(move))}
      />
    </>
  );
}

function LassoButtons({ document }: PanelProps) {
  const link = useLink();
  const { lasso, lassoThrough } = document;
  const disabled = isViewer(document);
  const button = (label: string, kind: Lasso, hint: string) => (
    <Button
      {...{ label, hint, disabled }}
      pressed={lasso === kind}
      onClick={() => link.send(command.lasso(lasso === kind ? "off" : kind, lassoThrough))}
    />
  );
  return (
    <Row>
      {button("Protect", "protect", "Draw a line around what shall not move")}
      {button("Release", "release", "Draw a line around what may move again")}
      <Check
        label="Through"
        on={lassoThrough}
        disabled={disabled}
        hint="The line also takes surface that faces away"
        onChange={(through) => link.send(command.lasso(lasso, through))}
      />
    </Row>
  );
}

function RegionButtons({ document }: PanelProps) {
  const link = useLink();
  const disabled = isViewer(document);
  const button = (label: string, words: string, hint: string) => (
    <Button {...{ label, hint, disabled }} onClick={() => link.send(command.protect(words))} />
  );
  return (
    <>
      <Row>
        {button("Grow", "grow 1", "The region grows by a cell of the grid")}
        {button("Shrink", "shrink 1", "The region shrinks by a cell of the grid")}
        {button("Invert", "invert", "The region becomes what is not protected now")}
      </Row>
      <Row>
        <Button
          label="Piece"
          hint="Protects the whole piece that the pointer was on last"
          disabled={disabled || !document.hasPiece}
          onClick={() => link.send(command.protectPiece())}
        />
        {button("Clear", "clear", "Nothing is protected")}
      </Row>
    </>
  );
}
