// The start page: a scan to open, the server, recent sessions, and lists of scans and sessions.

import { useState } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import { Button, Row } from "./controls";
import { ScanList, SessionList, pictureOf } from "./library_lists";
import type { Library, Session } from "./snapshot";
import { dayOf } from "./words";

/** The mesh formats, by the extension of a file. */
export const kMeshKinds = ["ply", "obj", "stl", "off", "glb", "gltf", "zip"] as const;
const kExtensions = kMeshKinds.map((one) => "." + one);
export const kMeshFiles = kExtensions.join(",");
const kCardsMax = 8;

export function StartPage({ library, onOpen }: { library: Library; onOpen: () => void }) {
  return (
    <main class="start">
      <h1>Burnish</h1>
      <p class="faint">smooths and sharpens scanned surfaces</p>
      <div class="start-columns">
        <div>
          <Button label="Open a scan…" class="strong open" hint="Chooses a mesh file (Ctrl+O)." onClick={onOpen} />
          <p class="faint">or drop a file on the page: {kExtensions.slice(0, -1).join(", ")} or {kExtensions.at(-1)}</p>
          <Server library={library} />
        </div>
        <div>
          <h2>Recent</h2>
          <Cards library={library} />
          <ScanList library={library} />
          <SessionList library={library} />
        </div>
      </div>
    </main>
  );
}

function Server({ library }: { library: Library }) {
  const link = useLink();
  const text = {
    unconnected: "not connected",
    connecting: `connecting to ${library.server}…`,
    connected: `connected to ${library.server}`,
    failed: library.problem,
  }[library.state];
  // The form stays while its words are tried.
  const [asks, setAsks] = useState(false);
  if (library.wantsToken !== asks && library.state !== "connecting") setAsks(library.wantsToken);
  const tone = { unconnected: "faint", connecting: "busy", connected: "good", failed: "bad" }[library.state];
  return (
    <section aria-label="Server">
      <h2>Server</h2>
      <p class={tone} role="status">
        {text}
      </p>
      {(library.wantsToken || asks) && <ConnectForm />}
      {library.state === "connected" && !link.hasToken() && <OwnName />}
      {library.state === "failed" && !library.wantsToken && (
        <Button label="Try again" onClick={() => link.send(command.refresh())} />
      )}
    </section>
  );
}

/** Asks for a name where no token tells it. */
function OwnName() {
  const link = useLink();
  return (
    <>
      <label class="labelled" title="It stands beside your edits. Undo takes back edits of this name.">
        <span>Your name</span>
        <input
          type="text"
          autocomplete="nickname"
          maxLength={100}
          value={link.ownName()}
          onChange={(event) => link.takeName(event.currentTarget.value.trim())}
        />
      </label>
      {link.ownName() === "" && (
        <p class="busy">Without a name you are a guest: Undo takes back the last edit of any guest.</p>
      )}
    </>
  );
}

/** The token stays in this tab and goes nowhere but to the server. */
function ConnectForm() {
  const link = useLink();
  const [user, setUser] = useState(link.user());
  const [token, setToken] = useState("");
  const connect = (event: Event) => {
    event.preventDefault();
    link.connect(user.trim(), token.trim());
  };
  return (
    <form aria-label="Connect" onSubmit={connect}>
      <label class="labelled" title="Your name, where the token does not tell it.">
        <span>User</span>
        <input
          type="text"
          autocomplete="username"
          value={user}
          onInput={(event) => setUser(event.currentTarget.value)}
        />
      </label>
      <label class="labelled" title="The secret that the keeper of the server gave you.">
        <span>Token</span>
        <input
          type="password"
          autocomplete="off"
          maxLength={1024}
          value={token}
          onInput={(event) => setToken(event.currentTarget.value)}
        />
      </label>
      <Row>
        <button class="strong">Connect</button>
      </Row>
      <p class="faint">The token is kept until you close this tab.</p>
    </form>
  );
}

function Cards({ library }: { library: Library }) {
  const recent = library.sessions
    .filter((session) => session.shown > 0)
    .sort((one, other) => other.shown - one.shown)
    .slice(0, kCardsMax);
  if (recent.length === 0) return <p class="faint">nothing opened yet</p>;
  return (
    <div class="cards">
      {recent.map((session) => (
        <Card key={session.id} session={session} />
      ))}
    </div>
  );
}

function Card({ session }: { session: Session }) {
  const link = useLink();
  const picture = pictureOf(link, session);
  return (
    <button
      class="card"
      aria-label={`Go on with ${session.name}`}
      onClick={() => link.send(command.joinSession(session.id))}
    >
      {picture ? <img src={picture} alt={`Picture of ${session.name}`} /> : <div class="no-picture" />}
      <span class="name">{session.name}</span>
      <span class="faint">{dayOf(session.shown)}</span>
    </button>
  );
}
