// Shows the address, and whether the server's socket answers.

const scheme = location.protocol === "https:" ? "wss:" : "ws:";
const address = `${scheme}//${location.host}/rpc`;
const state = document.getElementById("state");

document.getElementById("host").textContent = location.hostname;
document.getElementById("socket").textContent = address;

const socket = new WebSocket(address, "burnish.v1");
socket.binaryType = "arraybuffer";
let answered = false;

socket.onopen = () => {
  socket.send(JSON.stringify({ call: "grpc.health.v1.Health/Check" }));
  socket.send(new Uint8Array());
  socket.send(JSON.stringify({ end: true }));
};
socket.onmessage = (event) => {
  if (typeof event.data !== "string") return;
  const end = JSON.parse(event.data);
  answered = true;
  state.textContent =
    end.code === 0 ? "The server's socket answers." : `The server's socket answers: ${end.message}`;
  socket.close();
};
socket.onclose = () => {
  if (!answered) state.textContent = "The server's socket does not answer.";
};
