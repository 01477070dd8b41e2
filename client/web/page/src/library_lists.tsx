// The server's scans and sessions.

import { useState } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import { Button, NameField, Row } from "./controls";
import { Dialog } from "./dialog";
import type { EngineLink } from "./engine_link";
import type { Library, Scan, Session } from "./snapshot";
import { counted, dayOf, megabytes } from "./words";

/** Returns the address of a session's last picture in this browser; empty: there is none. */
export const pictureOf = (link: EngineLink, session: Session) => link.kept(`picture/${session.id}`);

/** Returns that of the session that showed the scan last. */
function pictureOfScan(link: EngineLink, scan: Scan, { sessions }: Library): string {
  const ofScan = sessions.filter((one) => one.scan === scan.id).sort((one, other) => other.shown - one.shown);
  return ofScan.map((one) => pictureOf(link, one)).find(Boolean) ?? "";
}

function ScanPicture({ scan, library }: { scan: Scan; library: Library }) {
  const picture = pictureOfScan(useLink(), scan, library);
  return picture ? <img class="thumb" src={picture} alt={`Picture of ${scan.name}`} /> : <span class="thumb" />;
}

const edits = (count: number) => `${count} ${count === 1 ? "edit" : "edits"}`;

function questionOf(scan: Scan, sessions: number): string {
  if (sessions === 0) return `The server deletes ${scan.name}.`;
  const what = sessions === 1 ? "1 session with its edits" : `${sessions} sessions with their edits`;
  return `The server deletes ${scan.name}, and ${what}.`;
}

export function ScanList({ library }: { library: Library }) {
  const link = useLink();
  const total = library.scans.reduce((sum, scan) => sum + scan.bytes, 0);
  return (
    <section aria-label="Scans">
      <h2>
        Scans <span class="faint">{library.scans.length > 0 && `${megabytes(total)} on disk`}</span>
      </h2>
      {library.scans.length === 0 ? (
        <p class="faint">none yet</p>
      ) : (
        <table>
          <thead>
            <tr>
              <th scope="col">name</th>
              <th scope="col">triangles</th>
              <th scope="col" class="roomy">surface</th>
              <th scope="col">on disk</th>
              <th scope="col" class="roomy">imported</th>
              <th scope="col" aria-label="actions" />
            </tr>
          </thead>
          <tbody>
            {library.scans.map((scan) => (
              <tr key={scan.id}>
                <td>
                  <div class="pictured">
                    <ScanPicture scan={scan} library={library} />
                    <Button
                      label={scan.name}
                      name={`Open ${scan.name}`}
                      class="link"
                      onClick={() => link.send(command.openScan(scan.id))}
                    />
                  </div>
                </td>
                <td>{counted(scan.triangles)}</td>
                <td class="roomy">{scan.closed ? "closed" : "open"}</td>
                <td>{megabytes(scan.bytes)}</td>
                <td class="roomy">{dayOf(scan.imported)}</td>
                <td>
                  <Row>
                    <Button
                      label="New"
                      name={`New session of ${scan.name}`}
                      hint="Opens it in a new session."
                      onClick={() => link.send(command.openScan(scan.id, true))}
                    />
                    <RenameAndDelete
                      name={scan.name}
                      question={questionOf(scan, library.sessions.filter((one) => one.scan === scan.id).length)}
                      onRename={(name) => link.send(command.renameScan(scan.id, name))}
                      onDelete={() => link.send(command.deleteScan(scan.id))}
                    />
                  </Row>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </section>
  );
}

export function SessionList({ library }: { library: Library }) {
  const link = useLink();
  const scanOf = (session: Session) =>
    library.scans.find((scan) => scan.id === session.scan)?.name ?? session.scan.slice(0, 8);
  return (
    <section aria-label="Sessions">
      <h2>Sessions</h2>
      {library.sessions.length === 0 ? (
        <p class="faint">none yet</p>
      ) : (
        <table>
          <thead>
            <tr>
              <th scope="col">name</th>
              <th scope="col">scan</th>
              <th scope="col">edits</th>
              <th scope="col" class="roomy">depth</th>
              <th scope="col" class="roomy">begun</th>
              <th scope="col" aria-label="actions" />
            </tr>
          </thead>
          <tbody>
            {library.sessions.map((session) => (
              <tr key={session.id}>
                <td>
                  <Button
                    label={session.name}
                    name={`Join ${session.name}`}
                    class="link"
                    onClick={() => link.send(command.joinSession(session.id))}
                  />
                </td>
                <td>{scanOf(session)}</td>
                <td>{session.edits}</td>
                <td class="roomy">{session.depth}</td>
                <td class="roomy">{dayOf(session.begun)}</td>
                <td>
                  <Row>
                    <RenameAndDelete
                      name={session.name}
                      question={`The server deletes ${session.name} with ${edits(session.edits)}.`}
                      onRename={(name) => link.send(command.renameSession(session.id, name))}
                      onDelete={() => link.send(command.deleteSession(session.id))}
                    />
                  </Row>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </section>
  );
}

function RenameAndDelete(props: {
  name: string;
  question: string;
  onRename: (name: string) => void;
  onDelete: () => void;
}) {
  const [asks, setAsks] = useState<"nothing" | "name" | "sure">("nothing");
  const close = () => setAsks("nothing");
  const after = (act: () => void) => () => {
    close();
    act();
  };
  return (
    <>
      <Button label="Rename" name={`Rename ${props.name}`} onClick={() => setAsks("name")} />
      <Button label="Delete" name={`Delete ${props.name}`} onClick={() => setAsks("sure")} />
      {asks === "name" && (
        <Dialog title={`Rename ${props.name}`} onClose={close}>
          <NameField
            name="New name"
            label="new name"
            button="Rename"
            start={props.name}
            onTake={(name) => after(() => name !== props.name && props.onRename(name))()}
          />
          <Button label="Cancel" onClick={close} />
        </Dialog>
      )}
      {asks === "sure" && (
        <Dialog title={`Delete ${props.name}`} onClose={close}>
          <p>{props.question}</p>
          <Row>
            <Button label="Delete for good" class="danger" onClick={after(props.onDelete)} />
            <Button label="Cancel" onClick={close} />
          </Row>
        </Dialog>
      )}
    </>
  );
}
