// The whole page: menu, start page or session, and what lies over both.

import { useEffect, useRef, useState } from "preact/hooks";
import { EditColumn, ShowSections, useIsWide } from "./columns";
import { command } from "./commands";
import { LinkContext } from "./context";
import { Button } from "./controls";
import { Dialog } from "./dialog";
import type { EngineLink } from "./engine_link";
import { ExportDialog } from "./export_dialog";
import { ColourBar, Hud, LostNote } from "./hud";
import type { PageActions } from "./key_actions";
import { KeyHelp } from "./key_help";
import { useKeyListeners } from "./key_listeners";
import { handleKeyDown, handleKeyUp } from "./keys";
import { MenuBar, type Shown } from "./menu_bar";
import { MessageLog, Toasts } from "./messages";
import { OverPicture } from "./over_picture";
import { Picture } from "./picture";
import { SectionPlot } from "./section_plot";
import { StartPage, kMeshFiles } from "./start_page";

const kClosed: Shown = { log: false, help: false, exporting: false };

export function Page({ link }: { link: EngineLink }) {
  const [state, setState] = useState(link.state);
  const [shown, setShown] = useState<Shown>(kClosed);
  const [figures, setFigures] = useState(true);
  const meshFile = useRef<HTMLInputElement>(null);
  const scriptFile = useRef<HTMLInputElement>(null);
  const isWide = useIsWide();
  const document = state.snapshot?.document ?? null;
  const opening = document ? "" : (state.snapshot?.opening ?? "");
  const hasPicture = document !== null || opening !== "";
  useEffect(() => {
    link.onchange = () => setState(link.state);
    setState(link.state);
    return link.listen();
  }, []);
  const actions: PageActions = {
    open: () => meshFile.current?.click(),
    exportMesh: () => setShown({ ...kClosed, exporting: true }),
    toggleLog: () => setShown({ ...kClosed, log: !shown.log }),
    toggleHelp: () => setShown({ ...kClosed, help: !shown.help }),
    closeOpen: () => setShown(kClosed),
  };
  useKeys(link, actions);
  useDrop(link);
  const title = document?.session ?? opening;
  useTitle(title ? `${title} – Burnish` : "Burnish");
  const close = () => setShown(kClosed);
  const messages = [...(state.snapshot?.messages ?? []), ...state.refusals];
  return (
    <LinkContext.Provider value={link}>
      <MenuBar
        {...{ document, actions, figures }}
        recording={state.snapshot?.recording ?? false}
        onFigures={(on) => {
          setFigures(on);
          link.send(command.figures(on));
        }}
        onReplay={() => scriptFile.current?.click()}
      />
      <div class={hasPicture ? (isWide ? "session wide" : "session") : "no-session"}>
        {document && (
          <EditColumn
            document={document}
            presets={state.snapshot?.presets ?? []}
            preset={state.snapshot?.preset ?? null}
            strengths={state.snapshot?.strengths ?? null}
          >
            {!isWide && <ShowSections {...{ document, figures }} />}
          </EditColumn>
        )}
        {opening && <OpeningColumn scan={opening} />}
        <div class="middle" hidden={!hasPicture}>
          <Picture key={state.starts} document={document} opening={opening} />
          {document && <OverPicture document={document} trial={state.snapshot?.strengths?.trial ?? ""} />}
          {document && <Hud document={document} figures={figures && isWide} />}
          {document?.view && document.scale && <ColourBar scale={document.scale} />}
          {document?.section && <SectionPlot section={document.section} ruler={document.over.rulerLength} />}
          {document && <LostNote document={document} />}
        </div>
        {document && isWide && (
          <aside class="column right" aria-label="Show">
            <ShowSections document={document} figures={false} />
          </aside>
        )}
        {!hasPicture && state.snapshot && (
          <StartPage library={state.snapshot.library} onOpen={actions.open} />
        )}
        {!state.snapshot && !state.stopped && (
          <main class="start">
            <h1>Burnish</h1>
            <p class="faint" role="status">
              loading…
            </p>
          </main>
        )}
      </div>
      <Toasts messages={messages} activities={state.snapshot?.activities ?? []} />
      {shown.log && <MessageLog messages={messages} onClose={close} />}
      {shown.help && <KeyHelp onClose={close} />}
      {shown.exporting && document && <ExportDialog document={document} onClose={close} />}
      {state.stopped && <Stopped link={link} reason={state.stopped} />}
      <FileInput
        input={meshFile}
        name="Mesh file"
        accept={kMeshFiles}
        onFile={(file) => link.post({ kind: "import", file })}
      />
      <FileInput
        input={scriptFile}
        name="Script file"
        accept=".script,.burnish,.txt"
        onFile={(file) => link.post({ kind: "replay", file })}
      />
    </LinkContext.Provider>
  );
}

/** Stands where the tools will be. */
function OpeningColumn({ scan }: { scan: string }) {
  return (
    <aside class="column left" aria-label="Edit">
      <h2>{scan}</h2>
      <p role="status">The session is being opened. The tools appear here when it is ready.</p>
      <p class="faint">The picture is a coarse one of the scan, without its edits.</p>
    </aside>
  );
}

function FileInput(props: {
  input: preact.RefObject<HTMLInputElement | null>;
  name: string;
  accept: string;
  onFile: (file: File) => void;
}) {
  return (
    <input
      ref={props.input}
      type="file"
      hidden
      aria-label={props.name}
      accept={props.accept}
      onChange={(event) => {
        const file = event.currentTarget.files?.[0];
        if (file) props.onFile(file);
        event.currentTarget.value = "";
      }}
    />
  );
}

function Stopped({ link, reason }: { link: EngineLink; reason: string }) {
  return (
    <Dialog title="The engine has stopped" onClose={() => link.startAgain()}>
      <p>{reason}</p>
      <p class="faint">Edits that the server has acknowledged are kept.</p>
      <Button label="Start again" class="strong" onClick={() => link.startAgain()} />
    </Dialog>
  );
}

function useKeys(link: EngineLink, page: PageActions): void {
  const context = () => ({ link, page, document: link.state.snapshot?.document ?? null });
  const isModal = () => window.document.querySelector("dialog[open]") !== null;
  useKeyListeners(
    link,
    (event) => !isModal() && handleKeyDown(event, context()),
    (event) => handleKeyUp(event, context()),
  );
}

/** A mesh file that is dropped anywhere on the page is imported. */
function useDrop(link: EngineLink): void {
  useEffect(() => {
    const over = (event: DragEvent) => event.preventDefault();
    const drop = (event: DragEvent) => {
      event.preventDefault();
      const file = event.dataTransfer?.files[0];
      if (file) link.post({ kind: "import", file });
    };
    window.addEventListener("dragover", over);
    window.addEventListener("drop", drop);
    return () => {
      window.removeEventListener("dragover", over);
      window.removeEventListener("drop", drop);
    };
  }, []);
}

function useTitle(title: string): void {
  useEffect(() => {
    window.document.title = title;
  }, [title]);
}
