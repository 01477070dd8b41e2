// The menus, with the words of the window's.

import { command } from "./commands";
import { useLink } from "./context";
import { Button } from "./controls";
import { keyNamed, type PageActions } from "./key_actions";
import { Menu, type MenuItem } from "./menu";
import type { Document } from "./snapshot";
import { chooseTheme, type Theme } from "./theme";

/** The dialogs that are open. */
export interface Shown {
  log: boolean;
  help: boolean;
  about: boolean;
  exporting: boolean;
  depths: boolean;
  leaving: boolean;
}

export interface MenuBarProps {
  document: Document | null;
  actions: PageActions;
  recording: boolean;
  figures: boolean;
  onFigures: (on: boolean) => void;
  panels: boolean;
  onPanels: (on: boolean) => void;
  onReplay: () => void;
  onAbout: () => void;
}

export function MenuBar(props: MenuBarProps) {
  const { document } = props;
  const link = useLink();
  const send = (line: string) => () => link.send(line);
  const title = document ? `${document.scan} · ${document.session}` : "";
  return (
    <header class="menus">
      <nav aria-label="Menus">
        <Menu name="File" items={fileItems(props, send)} />
        {document && (
          <Menu
            name="Edit"
            items={[
              { label: "Undo", what: document.undoName, key: keyNamed("undo"), run: send(command.undo()) },
              { label: "Redo", what: document.redoName, key: keyNamed("redo"), run: send(command.redo()) },
            ]}
          />
        )}
        <Menu name="View" items={viewItems(props, send)} />
        <Menu
          name="Help"
          items={[
            { label: "Keys", key: keyNamed("help"), run: props.actions.toggleHelp },
            { label: "About and manual", run: props.onAbout },
          ]}
        />
      </nav>
      {document && (
        <Button
          label="Panels"
          hint="Shows the panels beside the picture."
          pressed={props.panels}
          onClick={() => props.onPanels(!props.panels)}
        />
      )}
      {props.recording && <span class="bad">recording</span>}
      <span class="session-title faint" title={title}>
        {title}
      </span>
    </header>
  );
}

type Send = (line: string) => () => void;

function fileItems({ document, actions, recording, onReplay }: MenuBarProps, send: Send): MenuItem[] {
  const disabled = document === null;
  return [
    { label: "Open…", key: keyNamed("open"), run: actions.open },
    { label: "Export…", key: keyNamed("export"), disabled, divided: true, run: actions.exportMesh },
    {
      label: "Save picture",
      key: keyNamed("screenshot"),
      disabled,
      run: send(command.picture(`${document?.session ?? "picture"}.png`)),
    },
    {
      label: recording ? "Stop recording" : "Record a script",
      divided: true,
      run: send(command.record(!recording)),
    },
    { label: "Replay a script…", run: onReplay },
    { label: "Open again at depth…", disabled, divided: true, run: actions.chooseDepth },
    { label: "Close session", disabled, run: actions.closeSession },
  ];
}

function viewItems({ document, actions, figures, onFigures }: MenuBarProps, send: Send): MenuItem[] {
  const theme = (label: string, value: Theme): MenuItem => ({
    label,
    run: () => chooseTheme(value),
  });
  const ofSession: MenuItem[] = document
    ? [
        { label: "Frame all", key: keyNamed("frame_all"), run: send(command.frame()) },
        {
          label: "Wireframe",
          key: keyNamed("wireframe"),
          checked: document.view.wireframe,
          run: send(command.wireframe(!document.view.wireframe)),
        },
        {
          label: "Split",
          key: keyNamed("split"),
          checked: document.view.split,
          run: send(command.split(!document.view.split)),
        },
        { label: "Figures", checked: figures, run: () => onFigures(!figures) },
      ]
    : [];
  return [
    ...ofSession,
    { label: "Messages", key: keyNamed("log"), run: actions.toggleLog },
    { ...theme("Dark", "dark"), divided: true },
    theme("Light", "light"),
    theme("As the browser", "system"),
  ];
}
