// Where a code that was typed leads, for a web server that only has files: O is meant as 0, I and L as 1.
document.getElementById('ask').addEventListener('submit', (event) => {
  const code = document.getElementById('code').value.toUpperCase()
    .replace(/[-. _\u00b7]/g, '').replace(/O/g, '0').replace(/[IL]/g, '1');
  if (!/^[0-9A-HJKMNP-TV-Z]{8}$/.test(code)) return;
  event.preventDefault();
  location.href = './' + code + '/';
});
