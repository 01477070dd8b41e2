// The texts over the picture: state, figures, the scale of colours, and a lost connection.

import { Figures } from "./controls";
import type { ColourScale, Document } from "./snapshot";
import { editsWait } from "./words";

function chipOf(document: Document): [string, string] {
  if (document.link === "connecting") return ["connecting", "busy"];
  if (document.link === "lost" && document.moving) return ["moving to another server", "busy"];
  if (document.link === "lost") return ["connection lost, reconnecting", "bad"];
  if (document.link === "ended") return ["session ended", "bad"];
  return [document.state, document.settled ? "good" : "busy"];
}

/** Returns what to say by the picture of a status as "40 % of 2.25 M triangles: loading"; nothing while it moves. */
export function simplified(status: string): string {
  const part = /^([\d.]+) % of (?!.*: moving$)/.exec(status)?.[1];
  return part ? `simplified, ${part === "100" ? "99" : part} %` : "";
}

export function Hud({ document, figures }: { document: Document; figures: boolean }) {
  const [text, tone] = chipOf(document);
  return (
    <div class="hud" role="group" aria-label="Figures over the picture">
      <div class={tone} role="status">
        {text}
      </div>
      <div class="faint">{simplified(document.view.status)}</div>
      {figures && <Figures figures={document.figures} />}
      {document.tool === "look" && <div class="faint">left button turns the view (N)</div>}
    </div>
  );
}

export function ColourBar({ scale }: { scale: ColourScale }) {
  const place = 50 * (scale.part + 1);
  return (
    <div class="colour-bar" role="img" aria-label={`Scale of colours: ${scale.title}`}>
      <div>
        <span class="faint">{scale.title}</span> {scale.value}
      </div>
      <svg viewBox="0 0 100 9" preserveAspectRatio="none">
        <defs>
          <linearGradient id="blue-to-red">
            <stop offset="0" stop-color="#3370db" />
            <stop offset="0.5" stop-color="#cccccc" />
            <stop offset="1" stop-color="#db382e" />
          </linearGradient>
        </defs>
        <rect width="100" height="7" fill="url(#blue-to-red)" />
        {scale.value && <path class="mark" d={`M${place} 3l-2 6h4z`} />}
      </svg>
      <div class="ends">
        <span>{scale.low}</span>
        <span>{scale.middle}</span>
        <span>{scale.high}</span>
      </div>
    </div>
  );
}

/** Says why the picture is grey. Edits go on, and are sent when the link is back. */
export function LostNote({ document }: { document: Document }) {
  if (document.link === "live") return null;
  const edits = document.unsavedEdits;
  const kept = edits === 0 ? "" : editsWait(edits);
  const text = {
    connecting: "Connecting…",
    lost: document.moving ? "The session moves to another server…" : "Connection lost. It comes back by itself.",
    ended: "The session has ended.",
  }[document.link];
  return (
    <div class="lost" role="alert">
      <strong>{text}</strong>
      {document.linkReason && !document.moving && <div>{document.linkReason}</div>}
      {kept && <div>{kept}</div>}
    </div>
  );
}
