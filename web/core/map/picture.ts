/** Fetches the background picture, and keeps the last one while the next is on its way. */
export class PictureLoader {
  image: HTMLImageElement | null = null;
  private wanted = "";

  constructor(
    private readonly addressOf: (path: string) => string,
    private readonly onLoaded: () => void,
  ) {}

  /** Empty: none. What can't be fetched is left out. */
  load(path: string): void {
    if (path === this.wanted) return;
    this.wanted = path;
    if (!path) {
      this.image = null;
      return;
    }
    const image = new Image();
    image.onload = () => {
      if (this.wanted !== path) return;
      this.image = image;
      this.onLoaded();
    };
    image.onerror = () => {
      if (this.wanted === path) this.image = null;
    };
    image.src = this.addressOf(path);
  }
}
