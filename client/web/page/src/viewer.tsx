// The viewer of a publication: the picture, before and after, light and views. It edits nothing, and has no server.

import { useEffect, useState } from "preact/hooks";
import type { PublishedScan } from "../../engine/published/scan";
import { command } from "./commands";
import { LinkContext } from "./context";
import { Button, Choice } from "./controls";
import type { EngineLink } from "./engine_link";
import { Guides } from "./guides";
import { LostNote, simplified } from "./hud";
import { keyActions } from "./key_actions";
import { useKeyListeners } from "./key_listeners";
import { keyOf } from "./keys";
import { Toasts } from "./messages";
import { OverPicture } from "./over_picture";
import { Picture } from "./picture";
import type { Document } from "./snapshot";
import { Widgets } from "./widget_panel";

/** Actions of keys that look. */
const kKeys = ["frame_all", "focus", "wireframe", "split", "front", "back", "right", "left", "top", "bottom", "orthographic", "screenshot"];

export function Viewer({ scan, link }: { scan: PublishedScan; link: EngineLink }) {
  const [state, setState] = useState(link.state);
  const document = state.snapshot?.document ?? null;
  useEffect(() => {
    link.onchange = () => setState(link.state);
    setState(link.state);
    window.document.title = scan.title;
  }, []);
  const isOpen = document !== null;
  useEffect(() => {
    if (isOpen) link.send(command.tool("look"));
  }, [isOpen, state.starts]);
  useViewerKeys(link, document);
  const troubles = (state.snapshot?.messages ?? []).filter((one) => one.severity !== "info");
  if (state.stopped) return <Useless reason={state.stopped} />;
  return (
    <LinkContext.Provider value={link}>
      <main class="viewer middle">
        <Picture key={state.starts} document={document} />
        {document && <OverPicture document={document} />}
        {document && <Guides />}
        <Facts scan={scan} document={document} />
        {document && <LostNote document={document} />}
      </main>
      {document && <Bar document={document} link={link} />}
      {scan.credit && <footer class="credit faint">{scan.credit}</footer>}
      <Toasts messages={troubles} activities={[]} />
    </LinkContext.Provider>
  );
}

/** The texts over the picture that say what it shows. */
function Facts({ scan, document }: { scan: PublishedScan; document: Document | null }) {
  const status = document?.view.status ?? "loading…";
  return (
    <div class="hud" role="group" aria-label="What is shown">
      <strong>{scan.title}</strong>
      <div class="faint">{`${scan.triangles.toLocaleString("en")} triangles`}</div>
      <div class="faint" role="status">
        {simplified(status) || status}
      </div>
    </div>
  );
}

const kViews = ["Front", "Back", "Right", "Left", "Top", "Bottom"];
const kSides = [
  ["after", "Edited"],
  ["split", "Split"],
  ["before", "Original"],
] as const;

function Bar({ document, link }: { document: Document; link: EngineLink }) {
  const { view } = document;
  const side = view.original ? "before" : view.split ? "split" : "after";
  const show = (one: (typeof kSides)[number][0]) => {
    link.send(command.original(one === "before"));
    link.send(command.split(one === "split"));
  };
  return (
    <div class="viewer-bar" role="toolbar" aria-label="View">
      <div role="group" aria-label="Before and after">
        {kSides.map(([one, label]) => (
          <Button key={one} label={label} pressed={side === one} onClick={() => show(one)} />
        ))}
      </div>
      <Widgets panel="Light" widgets={document.panels.Light!.slice(0, 1)} />
      {document.hasColours && (
        <Choice
          name="Colour"
          value={view.colour}
          choices={[
            ["scan", "Colours of the scan"],
            ["clay", "Clay"],
          ]}
          onChange={(by) => link.send(command.colour(by))}
        />
      )}
      <div role="group" aria-label="Camera">
        <Button label="Frame all" onClick={() => link.send(command.frame())} />
        {kViews.map((one) => (
          <Button key={one} label={one} onClick={() => link.send(command.view(one.toLowerCase()))} />
        ))}
      </div>
    </div>
  );
}

/** Says why nothing can be shown. */
export const Useless = ({ reason }: { reason: string }) => (
  <main class="start">
    <p role="alert">{reason}</p>
  </main>
);

function useViewerKeys(link: EngineLink, document: Document | null): void {
  const isHeld = (event: KeyboardEvent) => event.key === " " && !(event.target instanceof HTMLButtonElement);
  const down = (event: KeyboardEvent) => {
    if (!document || event.target instanceof HTMLSelectElement) return;
    const action = keyActions.find(({ name, keys }) => kKeys.includes(name) && keys.includes(keyOf(event)));
    if (!action && !isHeld(event)) return;
    event.preventDefault();
    if (isHeld(event) && !event.repeat) link.send(command.original(true));
    action?.run({ link, document, page: kNoActions });
  };
  useKeyListeners(link, down, (event) => document && isHeld(event) && link.send(command.original(false)));
}

const nothing = () => {};
const kNoActions = { open: nothing, exportMesh: nothing, chooseDepth: nothing, closeSession: nothing, toggleLog: nothing, toggleHelp: nothing, closeOpen: nothing };
