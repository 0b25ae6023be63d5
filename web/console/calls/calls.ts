// A question or an alert told outside of the page: by a sound, and by the desktop.

export interface Call {
  /** The same for what takes the place of an earlier one. */
  tag: string;
  title: string;
  text: string;
}

/** What the browser gives, replaced in tests. */
export interface CallSurroundings {
  sound(): void;
  notify(call: Call): void;
  now(): number;
}

const kQuiet = 1500; // ms between two sounds

export class Calls {
  private readonly known = new Set<string>();
  private soundAt = Number.NEGATIVE_INFINITY;

  constructor(private readonly surroundings: CallSurroundings = kBrowser) {}

  /** What is there when they are switched on, or when the page opens, is known: only what comes after it is told. */
  know(calls: readonly Call[]): void {
    this.known.clear();
    for (const { tag } of calls) this.known.add(tag);
  }

  /** All that there is now; tells what is new. */
  see(calls: readonly Call[]): void {
    const fresh = calls.filter(({ tag }) => !this.known.has(tag));
    this.know(calls);
    for (const call of fresh) this.surroundings.notify(call);
    const now = this.surroundings.now();
    if (fresh.length === 0 || now - this.soundAt < kQuiet) return;
    this.soundAt = now;
    this.surroundings.sound();
  }
}

/** Asks the browser for leave. @returns what a person has to know; empty: sound and desktop both work */
export async function askForCalls(): Promise<string> {
  chime(0); // a page may sound once somebody has pressed something in it
  if (!("Notification" in window))
    return "This browser shows notifications only to pages of this machine, or with a certificate. There is sound alone.";
  const leave =
    Notification.permission === "default" ? await Notification.requestPermission() : Notification.permission;
  return leave === "granted" ? "" : "The browser does not let this page show notifications. There is sound alone.";
}

let audio: AudioContext | undefined;

/** Two tones, a fourth apart. */
function chime(loudness: number): void {
  if (!("AudioContext" in window)) return;
  audio ??= new AudioContext();
  void audio.resume();
  [660, 880].forEach((pitch, i) => {
    const tone = audio!.createOscillator();
    const gain = audio!.createGain();
    const begin = audio!.currentTime + i * 0.18;
    tone.frequency.value = pitch;
    gain.gain.setValueAtTime(loudness, begin);
    gain.gain.linearRampToValueAtTime(0, begin + 0.16);
    tone.connect(gain).connect(audio!.destination);
    tone.start(begin);
    tone.stop(begin + 0.18);
  });
}

const kBrowser: CallSurroundings = {
  sound: () => chime(0.25),
  notify({ title, text, tag }) {
    if (!("Notification" in window) || Notification.permission !== "granted") return;
    const shown = new Notification(title, { body: text, tag });
    shown.onclick = () => {
      window.focus();
      shown.close();
    };
  },
  now: () => performance.now(),
};
