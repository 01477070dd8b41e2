// The whole page: menu, start page or session, and what lies over both.

import { useEffect, useRef, useState } from "preact/hooks";
import { AboutDialog } from "./about_dialog";
import { useAddress } from "./address";
import { EditColumn, ShowSections, useIsWide } from "./columns";
import { command } from "./commands";
import { LinkContext } from "./context";
import { Button } from "./controls";
import type { EngineLink } from "./engine_link";
import { DepthDialog } from "./depth_dialog";
import { Dialog } from "./dialog";
import { ExportDialog } from "./export_dialog";
import { importFiles } from "./given_files";
import { Guides } from "./guides";
import { ColourBar, Hud, LostNote } from "./hud";
import type { PageActions } from "./key_actions";
import { KeyHelp } from "./key_help";
import { useKeyListeners } from "./key_listeners";
import { handleKeyDown, handleKeyUp } from "./keys";
import { LeaveQuestion } from "./leave_question";
import { MenuBar, type Shown } from "./menu_bar";
import { MessageLog, Toasts } from "./messages";
import { OverPicture } from "./over_picture";
import { Picture } from "./picture";
import { SectionPlot } from "./section_plot";
import { StartPage, kMeshFiles } from "./start_page";

const kFilesBeside = ",.mtl,.png,.jpg,.jpeg,.bin"; // of an OBJ, a PLY or a glTF
const kClosed: Shown = { log: false, help: false, about: false, exporting: false, depths: false, leaving: false };

export function Page({ link }: { link: EngineLink }) {
  const [state, setState] = useState(link.state);
  const [shown, setShown] = useState<Shown>(kClosed);
  const [figures, setFigures] = useState(true);
  const [panels, setPanels] = useState(true);
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
    chooseDepth: () => setShown({ ...kClosed, depths: true }),
    closeSession: () => (document?.unsavedEdits ? setShown({ ...kClosed, leaving: true }) : link.send(command.close())),
    toggleLog: () => setShown({ ...kClosed, log: !shown.log }),
    toggleHelp: () => setShown({ ...kClosed, help: !shown.help }),
    closeOpen: () => setShown(kClosed),
  };
  useKeys(link, actions);
  useDrop(link);
  useQuestionBeforeLeaving(link);
  const title = document?.session ?? opening;
  useAddress(link, document?.sessionId ?? "");
  useTitle(title ? `${title} – Burnish` : "Burnish");
  const close = () => setShown(kClosed);
  const messages = [...(state.snapshot?.messages ?? []), ...state.refusals];
  return (
    <LinkContext.Provider value={link}>
      <MenuBar
        {...{ document, actions, figures, panels }}
        onPanels={setPanels}
        recording={state.snapshot?.recording ?? false}
        onFigures={(on) => {
          setFigures(on);
          link.send(command.figures(on));
        }}
        onReplay={() => scriptFile.current?.click()}
        onAbout={() => setShown({ ...kClosed, about: true })}
      />
      <div class={hasPicture ? `session${isWide ? " wide" : ""}${panels || !document ? "" : " alone"}` : "no-session"}>
        {document && panels && (
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
        <main class="middle" hidden={!hasPicture}>
          <h1 class="unseen">{document ? `${document.scan} · ${document.session}` : opening}</h1>
          <Picture key={state.starts} document={document} opening={opening} />
          {document && <OverPicture document={document} trial={state.snapshot?.strengths?.trial ?? ""} />}
          {document && <Guides raised={document.scale !== null} />}
          {document && <Hud document={document} figures={figures && isWide} />}
          {document?.view && document.scale && <ColourBar scale={document.scale} />}
          {document?.section && <SectionPlot section={document.section} ruler={document.over.rulerLength} />}
          {document && <LostNote document={document} />}
        </main>
        {document && isWide && panels && (
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
      {shown.about && state.snapshot && <AboutDialog texts={state.snapshot.about} onClose={close} />}
      {shown.exporting && document && <ExportDialog document={document} onClose={close} />}
      {shown.depths && document && <DepthDialog document={document} onClose={close} />}
      {shown.leaving && document && <LeaveQuestion edits={document.unsavedEdits} onClose={close} />}
      {state.stopped && <Stopped link={link} reason={state.stopped} />}
      <FileInput
        input={meshFile}
        name="Mesh file"
        accept={kMeshFiles + kFilesBeside}
        several
        onFiles={(files) => void importFiles(link, files)}
      />
      <FileInput
        input={scriptFile}
        name="Script file"
        accept=".script,.burnish,.txt"
        onFiles={([file]) => file && link.post({ kind: "replay", file })}
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
  several?: boolean;
  onFiles: (files: File[]) => void;
}) {
  return (
    <input
      ref={props.input}
      type="file"
      hidden
      aria-label={props.name}
      accept={props.accept}
      multiple={props.several}
      onChange={(event) => {
        props.onFiles([...(event.currentTarget.files ?? [])]);
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

/** Mesh files that are dropped anywhere on the page are imported. */
function useDrop(link: EngineLink): void {
  useEffect(() => {
    const over = (event: DragEvent) => event.preventDefault();
    const drop = (event: DragEvent) => {
      event.preventDefault();
      void importFiles(link, [...(event.dataTransfer?.files ?? [])]);
    };
    window.addEventListener("dragover", over);
    window.addEventListener("drop", drop);
    return () => {
      window.removeEventListener("dragover", over);
      window.removeEventListener("drop", drop);
    };
  }, []);
}

/** Lets the browser ask before it closes the page over edits that wait for the server, or an export. */
function useQuestionBeforeLeaving(link: EngineLink): void {
  useEffect(() => {
    const ask = (event: Event) => {
      const { snapshot } = link.state;
      const isExporting = snapshot?.activities.some((activity) => activity.makesFile);
      if (snapshot?.document?.unsavedEdits || isExporting) event.preventDefault();
    };
    window.addEventListener("beforeunload", ask);
    return () => window.removeEventListener("beforeunload", ask);
  }, []);
}

function useTitle(title: string): void {
  useEffect(() => {
    window.document.title = title;
  }, [title]);
}
