// Caches the whole page, so that it works offline after the first visit. `files` and `version`
// come from the build; a new version replaces the old one as a whole, once no tab shows that.

import { files, version } from 'scenefile-assets';

const prefix = `scenefile-${registration.scope}-`; // a host may have several pages
const name = `${prefix}${version}`;

addEventListener('install', (event) => {
  event.waitUntil(
    caches
      .open(name)
      .then((cache) => cache.addAll(files.map((file) => new Request(file, { cache: 'reload' })))),
  );
});

addEventListener('activate', (event) => {
  event.waitUntil(
    caches
      .keys()
      .then((names) => Promise.all(names.filter((old) => old.startsWith(prefix) && old !== name).map((old) => caches.delete(old))))
      .then(() => self.clients.claim()), // so that the first visit can go on without a network
  );
});

addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET' || new URL(request.url).origin !== location.origin) {
    return;
  }
  event.respondWith(
    caches
      .open(name)
      .then((cache) => cache.match(request, { ignoreSearch: true }))
      .then((kept) => kept ?? fetch(request)),
  );
});
