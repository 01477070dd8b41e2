// The people in the session and their roles.

import { command } from "./commands";
import { useLink } from "./context";
import { Choice } from "./controls";
import type { PanelProps } from "./filter_panel";
import type { Document, Person, Role } from "./snapshot";
import { hexColour } from "./words";

const kRoles: Role[] = ["viewer", "editor", "owner"];

export function PeoplePanel({ document }: PanelProps) {
  if (document.people.length === 0) return <div class="faint">nobody is connected</div>;
  return (
    <ul class="people" aria-label="People here">
      {document.people.map((person) => (
        <PersonRow key={person.connection} {...{ document, person }} />
      ))}
    </ul>
  );
}

function PersonRow({ document, person }: { document: Document; person: Person }) {
  const link = useLink();
  const name = person.user || "guest";
  const mayChange = document.role === "owner" && person.user !== "";
  return (
    <li>
      <svg class="ring" viewBox="0 0 2 2" aria-hidden="true">
        <circle cx={1} cy={1} r={1} fill={hexColour(person.colour)} />
      </svg>
      <span class="name" title={name}>
        {person.me ? `${name} (you)` : name}
      </span>
      {mayChange ? (
        <Choice<Role>
          name={`Role of ${name}`}
          hint="A viewer looks, an editor edits, an owner changes roles too."
          value={person.role}
          choices={kRoles.map((role) => [role, role] as const)}
          onChange={(role) => link.send(command.role(person.user, role))}
        />
      ) : (
        <span class="faint" title="Only an owner changes roles.">
          {person.role}
        </span>
      )}
    </li>
  );
}
