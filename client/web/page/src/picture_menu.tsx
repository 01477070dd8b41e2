// The menu that a click of the right button in the picture asks for, with the items of the window's.

import { command } from "./commands";
import { useLink } from "./context";
import type { EngineLink } from "./engine_link";
import { isViewer, type PanelProps } from "./filter_panel";
import { keyNamed } from "./key_actions";
import { MenuList, type MenuItem } from "./menu";
import { focusPicture } from "./picture";
import type { Document } from "./snapshot";

const kViews = ["front", "back", "right", "left", "top", "bottom"] as const;

/** It closes when the focus leaves it. */
export function PictureMenu({ document }: PanelProps) {
  const link = useLink();
  const menu = document.over.menu;
  if (!menu) return null;
  const [x, y] = menu.place.map((pixel) => pixel / devicePixelRatio) as [number, number];
  // The point is the menu's, so its line comes before the one that closes it.
  const choose = (item: MenuItem) => {
    item.run();
    focusPicture();
  };
  return (
    <div class="menu picture-menu" onFocusOut={(event) => leaves(event) && link.send(command.closeMenu())}>
      <MenuList
        key={`${x} ${y}`}
        name="Picture"
        items={itemsOf(document, menu.position, link)}
        onChoose={choose}
        onClose={focusPicture}
        style={placeAt(x, y)}
      />
    </div>
  );
}

const leaves = (event: FocusEvent) =>
  !(event.relatedTarget instanceof Node && (event.currentTarget as HTMLElement).contains(event.relatedTarget));

/** Opens it towards the picture's middle, so that it lies within. */
function placeAt(x: number, y: number): Record<string, string | number> {
  const box = window.document.querySelector(".place")!.getBoundingClientRect();
  return {
    ...(x < box.width / 2 ? { left: x } : { left: "auto", right: box.width - x }),
    ...(y < box.height / 2 ? { top: y } : { top: "auto", bottom: box.height - y }),
    maxHeight: Math.max(y, box.height - y),
  };
}

function itemsOf(document: Document, position: string, link: EngineLink): MenuItem[] {
  const send = (line: string) => () => link.send(line);
  const views: MenuItem[] = kViews.map((view, number) => ({
    label: `From the ${view}`,
    key: keyNamed(view),
    divided: number === 0,
    run: send(command.view(view)),
  }));
  const disabled = isViewer(document);
  return [
    { label: "Look at this point", key: keyNamed("focus"), disabled: position === "", run: send(command.focus()) },
    { label: "Frame all", key: keyNamed("frame_all"), run: send(command.frame()) },
    ...views,
    { label: "Copy position", disabled: position === "", divided: true, run: () => copy(position, link) },
    { label: "Undo", what: document.undoName, key: keyNamed("undo"), disabled, divided: true, run: send(command.undo()) },
    { label: "Redo", what: document.redoName, key: keyNamed("redo"), disabled, run: send(command.redo()) },
    {
      label: "Save picture",
      key: keyNamed("screenshot"),
      divided: true,
      run: send(command.picture(`${document.session}.png`)),
    },
  ];
}

/** A page without TLS has no clipboard of its own, but for what is selected. */
function copy(text: string, link: EngineLink): void {
  const told = () => link.tell(`copied ${text}`);
  if (navigator.clipboard) return void navigator.clipboard.writeText(text).then(told);
  const field = window.document.createElement("textarea");
  field.value = text;
  window.document.body.append(field);
  field.select();
  if (window.document.execCommand("copy")) told();
  field.remove();
  focusPicture();
}
